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
    /** Its name. */
    var name: String = name

    /** The class of the agent: `agentClass` in a `.mas2j`. */
    var agentClass: Class<out Agent> = Agent::class.java

    /**
     * Creates its architecture: [Arch], or a subclass of the project's own that passes the platform on. Null: an agent of plain Jason,
     * which has no board.
     */
    var arch: ((Platform) -> Arch)? = ::Arch

    /**
     * The Jason environment that it is in, for actions that are not internal and for percepts that are not a board's; null: none. Its
     * actions take no time. Several agents of a test may share one. Its own threads, if any, run in real time.
     */
    var environment: Environment? = null

    /** The time that each of its reasoning cycles takes; the next cycle begins when that time is over. */
    var cycleTime: Duration = Duration.ZERO

    internal val platform = TestPlatform(time)
    internal var beliefBase: ClassParameters? = null
    internal val options = LinkedHashMap<String, String>()
    internal val sourcePaths = ArrayList<String>()

    /** Sets options, which a `.mas2j` has in brackets: `options("argo_sensing" to "every")`. */
    fun options(vararg options: Pair<String, String>) {
        this.options += options
    }

    /** Adds directories for included files, besides that of the `.asl`: `aslSourcePath` in a `.mas2j`. */
    fun sourcePath(vararg directories: String) {
        sourcePaths += directories
    }

    /** The board on the first port that the agent opens, if no other is named with [board]. */
    val board: Board get() = platform.first()

    /** Returns the board on [port]. */
    fun board(port: String): Board = platform.at(port)
}
