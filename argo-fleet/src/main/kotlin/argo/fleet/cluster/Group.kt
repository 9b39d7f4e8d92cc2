package argo.fleet.cluster

/**
 * The computers in touch, called members, and frames among them. A frame may be lost or come twice. A restarted computer is a new member.
 */
internal interface Group : AutoCloseable {
    val here: Computer

    /** Joins. [listener] may be called by several threads at once. */
    fun join(listener: GroupListener)

    /**
     * Sends [frame] if the network takes it; never waits. With one caller at a time, the order of frames changes only when a connection is
     * lost.
     */
    fun transmit(to: Computer, frame: ByteArray)
}

internal interface GroupListener {
    fun arrived(from: Computer, frame: ByteArray)

    /** [members] are in touch now. Of several members with one name, the oldest comes first. Calls come in the order of the views. */
    fun viewed(members: List<Computer>)
}

/** The thread of a cluster. */
internal interface Loop : AutoCloseable {
    /** Returns the nanoseconds since a fixed instant. */
    fun now(): Long

    /** Runs [task] after all tasks given before. */
    fun execute(task: () -> Unit)

    /** Runs [task] once, in [millis] ms. */
    fun after(millis: Long, task: () -> Unit)
}
