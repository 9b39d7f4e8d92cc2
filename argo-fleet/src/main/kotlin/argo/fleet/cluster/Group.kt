package argo.fleet.cluster

/**
 * The computers in touch, called members, and the frames between them. A frame may be lost or doubled. A restarted computer is a new
 * member.
 */
internal interface Group : AutoCloseable {
    val here: Computer

    /** Joins. [listener] may be called by several threads at once. */
    fun join(listener: GroupListener)

    /**
     * Sends [frame] if the network accepts it. Never waits. With one caller at a time, frames change their order only when a connection is
     * lost.
     */
    fun transmit(to: Computer, frame: ByteArray)
}

internal interface GroupListener {
    fun arrived(from: Computer, frame: ByteArray)

    /**
     * The members in touch are now [members]. Of several members with one name, the oldest comes first. The calls have the order of the
     * views.
     */
    fun viewed(members: List<Computer>)
}

/** The thread of a cluster. */
internal interface Loop : AutoCloseable {
    /** Returns the nanoseconds since a fixed instant. */
    fun now(): Long

    /** Runs [task] after all earlier tasks. */
    fun execute(task: () -> Unit)

    /** Runs [task] once, in [millis] ms. */
    fun after(millis: Long, task: () -> Unit)
}
