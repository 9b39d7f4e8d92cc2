package argo.fleet.cluster

/**
 * The computers in touch, its members, and frames among them. Frames may be lost or come twice. Another run of a program is another member.
 */
internal interface Group : AutoCloseable {
    val here: Computer

    /** Joins. [listener] may be called by several threads at once. */
    fun join(listener: GroupListener)

    /**
     * Sends [frame] if the network takes it; never waits. If there is only one caller at a time, frames overtake each other only where a
     * connection ends.
     */
    fun transmit(to: Computer, frame: ByteArray)
}

internal interface GroupListener {
    fun arrived(from: Computer, frame: ByteArray)

    /** [members] are in touch now; of several members with one name the oldest comes first. Views come in their order. */
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
