package argo.acting

import argo.boards.RuleLink
import argo.calls.Failure
import argo.platform.Platform
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.util.concurrent.CopyOnWriteArrayList
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger

class CommandSenderSpec : FunSpec({
    test("a receiver of an outcome that fails is told by the log, and the next command has its receiver told") {
        val lines = CopyOnWriteArrayList<String>()
        val log = Logger.getLogger(CommandSender::class.java.name)
        val handler = object : Handler() {
            override fun publish(record: LogRecord) {
                lines += record.message
            }

            override fun flush() = Unit
            override fun close() = Unit
        }
        log.addHandler(handler)
        try {
            val commands = CommandSender(RuleLink("robot"), "bob", Platform.system) { }
            commands.send("stop", CommandOptions()).follow({ }) { _, _ -> error("it is broken") }
            val outcomes = mutableListOf<Failure?>()
            commands.send("go", CommandOptions()).follow({ }) { failure, _ -> outcomes += failure }
            lines.single() shouldBe "the receiver of the outcome of \"stop\" has failed"
            outcomes shouldBe listOf(null)
        } finally {
            log.removeHandler(handler)
        }
    }
})
