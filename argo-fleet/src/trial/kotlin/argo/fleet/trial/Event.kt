package argo.fleet.trial

/** The kinds of noted events. */
enum class Kind {
    /** A message is about to be sent. Notes the receiving computer and the message's number in the session. */
    SENT,

    /** The end of a message, by number: it was taken, or it is reported as failed. */
    TAKEN, FAILED,

    /** The listener takes a message. Notes the sender's session and the message's number there. */
    TOOK,

    /** A new view: the names of its computers. */
    VIEWED,

    /** An agent that outlives its computer has acted here. Notes its name and the term of its reign. Each new reign has a greater term. */
    ACTED,

    /** All messages have ended, and nothing follows. CRASHED is noted by another program after a kill. */
    FINISHED, CRASHED,
}

/**
 * An event of a fleet's history.
 *
 * @property nanos the time of the event in ns of the machine's steady clock
 * @property session the run of a program on a computer, such as `scout1#2`
 * @property about facts of this [kind] of event, without spaces
 */
data class Event(val nanos: Long, val session: String, val kind: Kind, val about: List<String> = emptyList()) {
    override fun toString() = (listOf("$nanos", session, kind.name) + about).joinToString(" ")

    companion object {
        /** Reads an event in the form of [toString]. */
        fun of(line: String): Event = line.split(' ').let { (nanos, session, kind) ->
            Event(nanos.toLong(), session, Kind.valueOf(kind), line.split(' ').drop(3))
        }
    }
}
