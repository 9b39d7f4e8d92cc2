package argo.jason

import argo.Infrastructure
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.architecture.AgArch
import jason.infra.local.RunLocalMAS
import jason.mas2j.ClassParameters
import jason.mas2j.MAS2JProject
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger

class InfrastructureSpec : FunSpec({
    fun told(work: (Logger) -> Unit): List<String> {
        val lines = ArrayList<String>()
        val log = Logger.getAnonymousLogger().apply {
            useParentHandlers = false
            addHandler(
                object : Handler() {
                    override fun publish(record: LogRecord) {
                        lines += record.message
                    }

                    override fun flush() = Unit
                    override fun close() = Unit
                },
            )
        }
        work(log)
        return lines
    }

    /** Makes Jason's launcher for one computer, or [runner], run a project that declares [infrastructure]. */
    fun run(infrastructure: String, runner: RunLocalMAS = RunLocalMAS()) {
        runner.project = MAS2JProject().apply { this.infrastructure = ClassParameters(infrastructure) }
    }

    test("a fleet that Jason's launcher for one computer runs is told once, with what to type") {
        run("Fleet")
        told { log -> repeat(2) { Infrastructure.check(log) } } shouldBe listOf(
            "infrastructure: Fleet has no effect: Jason's launcher for one computer runs all agents of the project here; " +
                "\"java -jar argo-fleet.jar PROJECT.mas2j --at NAME\" runs the agents of one computer",
        )
    }

    test("so is any other infrastructure but Jason's own for one computer, and nothing that another launcher runs") {
        run("Jade")
        told(Infrastructure::check).size shouldBe 1
        run("Local")
        told(Infrastructure::check) shouldBe emptyList()
        run("Fleet", object : RunLocalMAS() {})
        told(Infrastructure::check) shouldBe emptyList()
    }

    test("the option of fleets without a fleet is told") {
        told { Infrastructure.checkFleetOption("agents", AgArch(), it) } shouldBe
            listOf("argo_fleet=agents has no effect: the agent runs in no fleet, which argo-fleet.jar starts")
        told { Infrastructure.checkFleetOption(null, AgArch(), it) } shouldBe emptyList()
    }
})
