package argo.recording.recorder

import argo.recording.agent.ProgramNames
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import jason.asSyntax.directives.DirectiveProcessor
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger

class StoredProgramSpec : FunSpec({
    test("steps in braces, which look like a directive, are none, and the log does not call them an unknown one") {
        val told = ArrayList<String>()
        val handler = object : Handler() {
            override fun publish(record: LogRecord) {
                told += record.message
            }

            override fun flush() = Unit

            override fun close() = Unit
        }
        val log = Logger.getLogger(DirectiveProcessor::class.java.name)
        log.addHandler(handler)
        try {
            foreignDirective(ProgramNames("+!go <- if (a) { .print(b) } else { fly(high) }.")) shouldBe null
        } finally {
            log.removeHandler(handler)
        }
        told.shouldBeEmpty()
    }
})
