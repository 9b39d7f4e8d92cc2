package argo.lsp.agents

import argo.check.syntax.Span

/** A change of blanks: [text] replaces the blanks at [span]. */
internal class Blanks(val span: Span, val text: String)
