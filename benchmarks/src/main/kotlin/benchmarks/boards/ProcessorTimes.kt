package benchmarks.boards

import benchmarks.processNanos
import java.lang.management.ManagementFactory

/** The groups of threads in an agent's process. */
internal enum class ThreadGroup(val title: String) {
    /** The threads that wait for answers, and read and filter them. */
    SENSING("sensing"),

    REASONING("reasoning"),

    /** Other threads of Java: commands, drivers, Jason. */
    OTHER("other threads"),

    /** The Java machine's own threads: compiler and garbage collector. */
    MACHINE("the Java machine"),
}

/** Processor times in ns since the process began. */
internal class ProcessorTimes private constructor(val process: Long, private val threads: Map<Long, Pair<ThreadGroup, Long>>) {
    /** Returns the times since [earlier]. The time of threads that have ended meanwhile counts for the Java machine. */
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
