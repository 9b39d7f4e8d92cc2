package argo.recording

import argo.testkit.AgentSetUp
import argo.testkit.agentOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.bb.IndexedBB
import jason.mas2j.ClassParameters
import jason.util.Config
import kotlin.io.path.exists
import kotlin.time.Duration.Companion.milliseconds

/** A recording refuses at its beginning, by name, every part that a replay could not have; the agent runs without a recording. */
class RefusedRecordingsSpec : FunSpec({
    fun shouldBeRefused(why: String, setUp: AgentSetUp.() -> Unit) {
        val file = recordingFile()
        agentOf("!start. +!start <- .print(started).") {
            setUp()
            options("argo_record" to "$file")
        }.use {
            it.after(300.milliseconds)
            it.printed shouldContain "started"
            it.log.filter { line -> "runs without a recording" in line }.shouldHaveSize(1).single() shouldContain why
        }
        file.exists() shouldBe false
    }

    test("an agent's class of the project") {
        shouldBeRefused("the agent's class planted.Moody is not Jason's") { agentClass = planted.Moody::class.java }
    }

    test("a belief base of the project") {
        val wanted = planted.Shuffled::class.java.name
        shouldBeRefused("the belief base $wanted is not Jason's own") { beliefBase = ClassParameters(wanted) }
    }

    test("another belief base of Jason's") {
        val wanted = IndexedBB::class.java.name
        shouldBeRefused("the belief base $wanted is not Jason's own") { beliefBase = ClassParameters(wanted) }
    }

    test("other plans for messages in Jason's configuration") {
        val before: Any? = Config.get().setProperty(Config.KQML_PLANS_FILE, "own-kqml.asl")
        try {
            shouldBeRefused("the plans for messages in own-kqml.asl") {}
        } finally {
            if (before == null) Config.get().remove(Config.KQML_PLANS_FILE) else Config.get()[Config.KQML_PLANS_FILE] = before
        }
    }

    test("code of Jason's that this version does not know") {
        val file = recordingFile()
        agentOf("!start. +!start <- jason.planted.unheard(X); .print(X).") { options("argo_record" to "$file") }.use {
            it.after(300.milliseconds)
            it.printed shouldContain "7"
            it.log.single { line -> "runs without a recording" in line } shouldContain "the program uses jason.planted.unheard, of which"
        }
    }

    for ((where, steps) in listOf(
        "a plan that is added" to """.add_plan("+!x(X) <- jason.planted.unheard(X)."); .wait(50); !x(X)""",
        "a term that is made of a text" to """.term2string(T, "jason.planted.unheard(X)"); T; .wait(50)""",
    )) {
        test("code of Jason's that this version does not know, in $where: the agent goes on") {
            val file = recordingFile()
            agentOf("!start. +!start <- .wait(50); $steps; .print(X).") { options("argo_record" to "$file") }.use {
                it.after(300.milliseconds)
                it.printed shouldContain "7"
                it.log.single { line -> "runs without a recording" in line } shouldContain "the program uses jason.planted.unheard, of which"
            }
        }
    }
})
