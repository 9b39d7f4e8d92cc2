package argo.fleet.cluster

/** A member of a group: a program on a computer. Another start of it is another member. */
internal data class Member(val name: String, val session: String)

/** The members in touch, and frames among them, which may be lost or come twice. */
internal interface Group : AutoCloseable {
    val here: Member

    /** Joins. [listener] may be called by several threads at once. */
    fun join(listener: GroupListener)

    /**
     * Sends [frame] if the network takes it; never waits. With one caller at a time, frames overtake each other only where a connection
     * ends.
     */
    fun transmit(to: Member, frame: ByteArray)
}

internal interface GroupListener {
    fun arrived(from: Member, frame: ByteArray)

    /** [members] are in touch now; of several with one name the first one is the oldest. Calls are in order. */
    fun viewed(members: List<Member>)
}

/** The thread of a cluster. */
internal interface Loop : AutoCloseable {
    /** Returns the nanoseconds since a fixed instant. */
    fun now(): Long

    /** Runs [task] after all tasks given before. */
    fun execute(task: () -> Unit)

    /** Runs [task] every [millis] ms until the loop is closed. */
    fun every(millis: Long, task: () -> Unit)
}
