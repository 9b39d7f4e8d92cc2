package argo.testkit

import argo.Arch
import argo.platform.Platform
import jason.asSemantics.Agent
import jason.environment.Environment
import jason.mas2j.ClassParameters

/** What an agent under test is like, and what it finds when it starts: the receiver of [argo.testkit.agent]'s last argument. */
@TestSetUp
class AgentSetUp internal constructor(time: VirtualTime, name: String) {
    /** What it is called. */
    var name: String = name

    /** The class of the agent: `agentClass` in a `.mas2j`. */
    var agentClass: Class<out Agent> = Agent::class.java

    /** Makes its architecture, for an architecture of the project's own: a subclass of [Arch] that passes the platform on. */
    var arch: (Platform) -> Arch = ::Arch

    /**
     * The Jason environment that it is in, for actions that are not internal and for percepts that are not a board's; null: none. Its actions take no time.
     * Several agents of a test may be in one. What it does on threads of its own goes by the machine's time.
     */
    var environment: Environment? = null

    internal val bench = Bench(time)
    internal var beliefBase: ClassParameters? = null
    internal val options = LinkedHashMap<String, String>()
    internal val sourcePaths = ArrayList<String>()

    /** Sets options as they stand in brackets in a `.mas2j`: `options("argo_sensing" to "every")`. */
    fun options(vararg options: Pair<String, String>) {
        this.options += options
    }

    /** Adds directories in which included files are looked for, besides that of the `.asl`: `aslSourcePath` in a `.mas2j`. */
    fun sourcePath(vararg directories: String) {
        sourcePaths += directories
    }

    /** The board on the first port that the agent opens, if no other is named with [board]. */
    val board: Board get() = bench.first()

    /** The board on [port]. */
    fun board(port: String): Board = bench.at(port)
}
