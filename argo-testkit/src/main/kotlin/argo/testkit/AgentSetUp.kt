package argo.testkit

import argo.Arch
import argo.platform.Platform
import jason.asSemantics.Agent
import jason.environment.Environment
import jason.mas2j.ClassParameters
import kotlin.time.Duration

/** The configuration of an agent under test and of its boards. [argo.testkit.agent]'s last argument has this class as its receiver. */
@TestSetUp
class AgentSetUp internal constructor(time: VirtualTime, name: String) {
    /** The agent's name. */
    var name: String = name

    /** The class of the agent: `agentClass` in a `.mas2j`. */
    var agentClass: Class<out Agent> = Agent::class.java

    /**
     * Creates the agent's architecture: [Arch] or a subclass, with the platform as its argument. Null means an agent of plain Jason without
     * a board.
     */
    var arch: ((Platform) -> Arch)? = ::Arch

    /**
     * The agent's Jason environment, for external actions and for percepts without a board, or null for none. Actions of the environment
     * take no time. Several agents of a test may share an environment. Threads of the environment run in real time.
     */
    var environment: Environment? = null

    /** The time that each reasoning cycle takes. The next cycle starts after this time. */
    var cycleTime: Duration = Duration.ZERO

    internal val platform = TestPlatform(time)
    internal var beliefBase: ClassParameters? = null
    internal val options = LinkedHashMap<String, String>()
    internal val sourcePaths = ArrayList<String>()

    /** Sets the options that a `.mas2j` has in brackets: `options("argo_sensing" to "every")`. */
    fun options(vararg options: Pair<String, String>) {
        this.options += options
    }

    /** Adds directories for included files. The directory of the `.asl` is always used. In a `.mas2j`, this is `aslSourcePath`. */
    fun sourcePath(vararg directories: String) {
        sourcePaths += directories
    }

    /** The board on the agent's first port: the first that [board] names or that the agent opens. */
    val board: Board get() = platform.first()

    /** Returns the board on [port]. */
    fun board(port: String): Board = platform.at(port)
}
