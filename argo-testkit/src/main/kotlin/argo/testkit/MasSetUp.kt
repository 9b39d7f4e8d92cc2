package argo.testkit

import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

/** Which agents there are, and what they find when they start: the receiver of [mas]'s argument. */
@TestSetUp
class MasSetUp internal constructor(private val mas: TestMas) {
    /** The agent in the file [source], as [argo.testkit.agent] finds it. */
    fun agent(source: String, setUp: AgentSetUp.() -> Unit = {}) {
        make(found(source), setUp)
    }

    /** The agent in [file]. */
    fun agent(file: Path, setUp: AgentSetUp.() -> Unit = {}) {
        make(existing(file), setUp)
    }

    /** An agent with [program]; it is called [name]. */
    fun agentOf(name: String, program: String, setUp: AgentSetUp.() -> Unit = {}) {
        written(program) { mas.make(it, "$name.asl", AgentSetUp(mas.time, name).apply(setUp)) }
    }

    private fun make(file: Path, setUp: AgentSetUp.() -> Unit) {
        mas.make(file, "$file", AgentSetUp(mas.time, file.nameWithoutExtension).apply(setUp))
    }
}

/** What is said of one agent is not said within another. */
@DslMarker
annotation class TestSetUp
