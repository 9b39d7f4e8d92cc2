package argo.connecting

/** The state of a port in an agent's beliefs, as in `port(ttyACM0,on)`. */
internal enum class PortStatus(val word: String) {
    /** Open, and without trouble since the last answer. */
    ON("on"),

    /** Not open: it could not be opened, or its device has gone. */
    OFF("off"),

    /** Open, but the board did not answer in time. */
    TIMEOUT("timeout");

    companion object {
        /** The atoms that can be a port's status. */
        val WORDS: Set<String> = entries.map { it.word }.toSet()
    }
}
