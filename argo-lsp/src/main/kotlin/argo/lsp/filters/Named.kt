package argo.lsp.filters

/** A name that a filter file may have at some place, with its meaning in words. */
internal data class Named(val name: String, val documentation: String)
