package argo.testkit

import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

/** The agents of a test and their configuration: the receiver of [mas]'s argument. */
@TestSetUp
class MasSetUp internal constructor(private val mas: TestMas) {
    /** Adds the agent in the file [source], for which it searches like [argo.testkit.agent]. */
    fun agent(source: String, setUp: AgentSetUp.() -> Unit = {}) {
        make(found(source), setUp)
    }

    /** Adds the agent in [file]. */
    fun agent(file: Path, setUp: AgentSetUp.() -> Unit = {}) {
        make(existing(file), setUp)
    }

    /** Adds an agent with [program] and [name]. */
    fun agentOf(name: String, program: String, setUp: AgentSetUp.() -> Unit = {}) {
        written(program) { mas.make(it, "$name.asl", AgentSetUp(mas.time, name).apply(setUp)) }
    }

    private fun make(file: Path, setUp: AgentSetUp.() -> Unit) {
        mas.make(file, "$file", AgentSetUp(mas.time, file.nameWithoutExtension).apply(setUp))
    }
}

/** Marks configurations, so that one agent's configuration cannot be nested in another's. */
@DslMarker
annotation class TestSetUp
