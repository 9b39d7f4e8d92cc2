package argo.lsp.agents

import argo.check.syntax.Span

/** Blanks that stand in the place of others. */
internal class Blanks(val span: Span, val text: String)
