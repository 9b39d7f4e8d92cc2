package argo.fleet.trial

/** What a program of a fleet noted. */
enum class Kind {
    /** Before a message was sent: to which computer, and its number in the session. */
    SENT,

    /** The end of a message, by its number: it was taken, or is reported failed. */
    TAKEN, FAILED,

    /** Within the listener, a message was taken: of which session, and its number there. */
    TOOK,

    /** Another view: the names of its computers. */
    VIEWED,

    /** An agent that outlives its computer has acted here: its name, and the term of the reign in which it has. Each reign's is greater. */
    ACTED,

    /** Everything that was sent has ended, and nothing follows; or somebody else noted that the program was killed. */
    FINISHED, CRASHED,
}

/**
 * An event of a fleet's history.
 *
 * @property nanos when it happened, in nanoseconds of the machine's steady clock
 * @property session the start of a program on a computer, as `scout1#2`
 * @property about what it is about, by its [kind]; without spaces
 */
data class Event(val nanos: Long, val session: String, val kind: Kind, val about: List<String> = emptyList()) {
    override fun toString() = (listOf("$nanos", session, kind.name) + about).joinToString(" ")

    companion object {
        /** Reads the form of [toString]. */
        fun of(line: String): Event = line.split(' ').let { (nanos, session, kind) ->
            Event(nanos.toLong(), session, Kind.valueOf(kind), line.split(' ').drop(3))
        }
    }
}
