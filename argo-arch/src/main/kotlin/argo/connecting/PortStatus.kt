package argo.connecting

/** What an agent believes of a port, as in `port(ttyACM0,on)`. */
internal enum class PortStatus(val word: String) {
    /** Open, and nothing has gone wrong since the last answer. */
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
