package argo.fleet.agents

import argo.fleet.node.Directory
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.string.shouldContain

class QuestionsSpec : FunSpec({
    val withoutOthers = Directory("base")

    test("a question that fails before its action waits for it has failed then") {
        val questions = Questions()
        questions.ask("mid1", "b", "scout1")
        questions.failLost(withoutOthers)
        questions.end("mid1").shouldNotBeNull().join().shouldNotBeNull().message shouldContain "scout1 is off"
    }

    test("a question is forgotten when no intention waits for it any more") {
        val questions = Questions()
        questions.ask("mid1", "b", "scout1")
        questions.failLost(withoutOthers)
        questions.endAllBut(emptySet())
        questions.end("mid1").shouldBeNull()
    }
})
