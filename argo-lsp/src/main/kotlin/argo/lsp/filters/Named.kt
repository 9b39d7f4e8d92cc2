package argo.lsp.filters

/** A name that is possible at some place of a filter file, with its meaning in words. */
internal data class Named(val name: String, val documentation: String)
