package argo.fleet.cluster

/**
 * Computers of a fleet in one program, without sockets, threads and real time. Things happen only in [run] and [advance]. Lost connections
 * are known at once.
 *
 * @param hosts the computers of the fleet
 * @param isLost returns true if a frame is lost on its way
 */
internal class InMemoryNetwork(private val hosts: Set<String>, private val isLost: (Computer, Computer) -> Boolean = { _, _ -> false }) {
    private inner class Node(override val here: Computer) : Group, Loop {
        private var later = listOf<() -> Unit>()
        var listener: GroupListener? = null
        val isUp get() = listener != null

        override fun join(listener: GroupListener) {
            this.listener = listener
            tellViews()
        }

        override fun transmit(to: Computer, frame: ByteArray) {
            val copy = frame.copyOf()
            if (!isUp) return
            enqueue { nodes.lastOrNull { it.here == to && reaches(this, it) && !isLost(here, to) }?.listener?.arrived(here, copy) }
        }

        override fun now(): Long = nanos
        override fun execute(task: () -> Unit) = enqueue(task)

        override fun after(millis: Long, task: () -> Unit) {
            check(millis == TICK_MILLIS)
            later += task
        }

        fun tick() {
            val due = later
            later = emptyList()
            due.forEach { if (isUp) it() }
        }

        /** Ends both the group and the loop. */
        override fun close() {
            if (!isUp) return
            listener = null
            tellViews()
        }
    }

    private val nodes = mutableListOf<Node>()
    private val tasks = ArrayDeque<() -> Unit>()
    private var sides = listOf<Set<String>>()
    private var nanos = 0L
    private var starts = 0

    /** Starts or restarts the program of a computer. The computer joins with [Cluster.listen]. */
    @Synchronized
    fun join(name: String): Cluster {
        val node = Node(Computer(name, "session ${++starts}"))
        nodes += node
        return GroupCluster(node, hosts, node)
    }

    /** Computers reach only those of their side. Computers on no side reach each other. */
    fun part(vararg sides: Set<String>) {
        this.sides = sides.toList()
        tellViews()
    }

    fun heal() = part()

    /** The computer [by] loses [lost] and finds it again. [lost] notices nothing, as after a halt of its program. */
    fun loseOneSided(by: String, lost: String) = nodes.filter { it.isUp && it.here.name == by }.forEach { node ->
        val seen = nodes.filter { reaches(node, it) }.map { it.here }
        listOf(seen.filter { it.name != lost }, seen).forEach { members -> enqueue { node.listener?.viewed(members) } }
    }

    /** Ends the program on [name] abruptly. */
    fun crash(name: String) {
        nodes.filter { it.here.name == name }.forEach { it.listener = null }
        tellViews()
    }

    /** Runs all tasks that are due. */
    fun run() {
        while (true) (synchronized(this) { tasks.removeFirstOrNull() } ?: return)()
    }

    /** Lets [millis] pass, and runs all tasks that become due. */
    fun advance(millis: Long) = repeat((millis / TICK_MILLIS).toInt()) {
        run()
        nanos += TICK_MILLIS * NANOS_PER_MILLI
        nodes.toList().forEach(Node::tick)
        run()
    }

    @Synchronized
    private fun enqueue(task: () -> Unit) {
        tasks += task
    }

    private fun side(node: Node) = sides.indexOfFirst { node.here.name in it }
    private fun reaches(one: Node, other: Node) = one.isUp && other.isUp && side(one) == side(other)

    private fun tellViews() = nodes.filter { it.isUp }.forEach { node ->
        val seen = nodes.filter { reaches(node, it) }.map { it.here }
        enqueue { if (node.isUp) node.listener?.viewed(seen) }
    }

    private companion object {
        const val TICK_MILLIS = 100L
        const val NANOS_PER_MILLI = 1_000_000L
    }
}
