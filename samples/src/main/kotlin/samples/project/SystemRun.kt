package samples.project

/** One run of a sample in this program, which prints the log of its agents and boards. */
internal class SystemRun(project: SampleProject) {
    private val mas = MasRun(project)

    /** Runs it until its agents end it, and returns their exit status; 1 if they have not ended it within [MAX_S] s. */
    fun toItsEnd(): Int = run(MAX_S) ?: 1.also { System.err.println("the agents have not ended within $MAX_S s") }

    /** Runs it for [seconds] s, with exit status 0, or until its agents end it, with their exit status. */
    fun forAtMost(seconds: Int): Int = run(seconds) ?: 0

    private fun run(seconds: Int): Int? {
        Logs.to(System.out)
        mas.begin()
        try {
            return mas.awaitEnd(seconds * 1000L)
        } finally {
            mas.end()
        }
    }

    private companion object {
        const val MAX_S = 60
    }
}
