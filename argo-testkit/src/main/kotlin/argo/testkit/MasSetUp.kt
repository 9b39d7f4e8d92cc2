package argo.testkit

import java.nio.file.Path
import kotlin.io.path.nameWithoutExtension

/** The agents of a test and their configuration. [mas]'s argument has this class as its receiver. */
@TestSetUp
class MasSetUp internal constructor(private val mas: TestMas) {
    /** Adds the agent in the file [source]. [argo.testkit.agent] tells where the file is searched. */
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

/** Prevents that one agent's configuration is nested in another's. */
@DslMarker
annotation class TestSetUp
