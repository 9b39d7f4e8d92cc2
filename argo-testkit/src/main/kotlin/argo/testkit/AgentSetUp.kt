package argo.testkit

import argo.Arch
import argo.platform.Platform
import jason.asSemantics.Agent
import jason.environment.Environment
import jason.mas2j.ClassParameters
import kotlin.time.Duration

/** The configuration of an agent under test and of its boards: the receiver of [argo.testkit.agent]'s last argument. */
@TestSetUp
class AgentSetUp internal constructor(time: VirtualTime, name: String) {
    /** The agent's name. */
    var name: String = name

    /** The class of the agent: `agentClass` in a `.mas2j`. */
    var agentClass: Class<out Agent> = Agent::class.java

    /**
     * Creates the agent's architecture: [Arch], or the project's own subclass with the platform as its argument. Null: an agent of plain
     * Jason, without a board.
     */
    var arch: ((Platform) -> Arch)? = ::Arch

    /**
     * The agent's Jason environment, for external actions and for percepts that come from no board; null: none. Its actions take no time.
     * Several agents of a test may share one environment. Threads of the environment run in real time.
     */
    var environment: Environment? = null

    /** The time that each reasoning cycle of the agent takes. The next cycle begins when this time is over. */
    var cycleTime: Duration = Duration.ZERO

    internal val platform = TestPlatform(time)
    internal var beliefBase: ClassParameters? = null
    internal val options = LinkedHashMap<String, String>()
    internal val sourcePaths = ArrayList<String>()

    /** Sets options, which a `.mas2j` writes in brackets: `options("argo_sensing" to "every")`. */
    fun options(vararg options: Pair<String, String>) {
        this.options += options
    }

    /** Adds directories for included files, in addition to the directory of the `.asl`: `aslSourcePath` in a `.mas2j`. */
    fun sourcePath(vararg directories: String) {
        sourcePaths += directories
    }

    /** The board on the first port that a call of [board] names or the agent opens. */
    val board: Board get() = platform.first()

    /** Returns the board on [port]. */
    fun board(port: String): Board = platform.at(port)
}
