package argo.tools.replay

import picocli.CommandLine.Option
import java.math.BigDecimal

/** The options of `replay` for a recording of agents. */
internal class AgentReplayOptions {
    /** Whether everything is named that gives another result each time. */
    @Option(names = ["--check"], description = ["names all that gives another result each time; then the exit status is 1"])
    var isCheck = false
        private set

    /** Where the replay ends, in seconds since the first cycle; null: at the end. */
    @Option(names = ["--until"], paramLabel = "S", description = ["replays the cycles before this second, and prints the beliefs there"])
    var until: BigDecimal? = null
        private set

    /** The agents whose beliefs are printed. */
    @Option(names = ["--of"], paramLabel = "AGENT", description = ["prints the beliefs of this agent alone; may be given several times"])
    var of: Set<String> = emptySet()
        private set

    /** Where Jason and the project's classes are besides here; null: nowhere. */
    @Option(names = ["--class-path"], paramLabel = "PATH", description = ["the project's classes and jars, and Jason's, as for java -cp"])
    var classPath: String? = null
        private set

    /** Whether the result is JSON. */
    @Option(names = ["--json"], description = ["prints JSON"])
    var json = false
        private set

    /** These options without the class path, as arguments. */
    fun arguments(): List<String> = buildList {
        if (isCheck) add("--check")
        if (json) add("--json")
        until?.let { add("--until=${it.toPlainString()}") }
        of.forEach { add("--of=$it") }
    }
}
