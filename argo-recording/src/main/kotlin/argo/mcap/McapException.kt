package argo.mcap

import java.io.IOException

/** A file cannot be read as MCAP, or holds something that this version cannot read. The message is for a person. */
class McapException(message: String) : IOException(message)
