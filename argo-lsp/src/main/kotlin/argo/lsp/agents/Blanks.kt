package argo.lsp.agents

import argo.check.syntax.Span

/** The blanks [text] in place of the blanks at [span]. */
internal class Blanks(val span: Span, val text: String)
