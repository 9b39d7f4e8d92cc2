package benchmarks.boards

import benchmarks.processNanos
import java.lang.management.ManagementFactory

internal enum class ThreadGroup(val title: String) {
    /** The threads that wait for answers, read them and filter them. */
    SENSING("sensing"),

    REASONING("reasoning"),

    /** Other Java threads: commands, drivers, Jason. */
    OTHER("other threads"),

    /** The threads of the Java virtual machine: compiler and garbage collector. */
    MACHINE("the Java machine"),
}

/** Processor times in ns since the start of the process. */
internal class ProcessorTimes private constructor(val process: Long, private val threads: Map<Long, Pair<ThreadGroup, Long>>) {
    /** Returns the times since [earlier]. The time of ended threads counts for the Java virtual machine. */
    operator fun minus(earlier: ProcessorTimes) = ProcessorTimes(
        process - earlier.process,
        threads.mapValues { (id, thread) -> thread.first to thread.second - (earlier.threads[id]?.second ?: 0) },
    )

    fun of(group: ThreadGroup): Long =
        if (group == ThreadGroup.MACHINE) process - threads.values.sumOf { it.second }
        else threads.values.filter { it.first == group }.sumOf { it.second }

    companion object {
        fun now(): ProcessorTimes {
            val threads = ManagementFactory.getThreadMXBean()
            val times = threads.getThreadInfo(threads.allThreadIds).filterNotNull()
                .associate { it.threadId to (groupOf(it.threadName) to maxOf(0, threads.getThreadCpuTime(it.threadId))) }
            return ProcessorTimes(processNanos(), times)
        }

        private fun groupOf(name: String) = when {
            "-sensing-" in name -> ThreadGroup.SENSING
            name.startsWith("MAS:") || name.startsWith("Local-agent") || name.contains("robot") && !name.startsWith("argo-") ->
                ThreadGroup.REASONING
            else -> ThreadGroup.OTHER
        }
    }
}
