package argo.testkit

import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

/** The agents of a test and their configuration: the receiver of [mas]'s argument. */
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

    /** An agent with [program] and [name]. */
    fun agentOf(name: String, program: String, setUp: AgentSetUp.() -> Unit = {}) {
        written(program) { mas.make(it, "$name.asl", AgentSetUp(mas.time, name).apply(setUp)) }
    }

    private fun make(file: Path, setUp: AgentSetUp.() -> Unit) {
        mas.make(file, "$file", AgentSetUp(mas.time, file.nameWithoutExtension).apply(setUp))
    }
}

/** The configuration of one agent cannot be written within that of another. */
@DslMarker
annotation class TestSetUp
