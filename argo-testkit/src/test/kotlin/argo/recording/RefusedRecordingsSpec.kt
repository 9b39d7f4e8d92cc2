package argo.recording

import argo.testkit.AgentSetUp
import argo.testkit.agentOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import jason.asSemantics.Event
import jason.asSemantics.Intention
import jason.asSemantics.TransitionSystem
import jason.asSyntax.ASSyntax
import jason.bb.IndexedBB
import jason.mas2j.ClassParameters
import jason.util.Config
import java.lang.ref.WeakReference
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread
import kotlin.io.path.exists
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

private fun byThread(ts: TransitionSystem): WeakReference<Event> {
    val event = Event(ASSyntax.parseTrigger("+ring(1)"), Intention.EmptyInt)
    thread { ts.c.addEvent(event) }.join()
    return WeakReference(event)
}

/**
 * A recording names everything that a replay could not repeat. At the start, the agent then runs without a recording. Later, a replay ends
 * at that cycle.
 */
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
            it.log.single { line -> "runs without a recording" in line } shouldContain "uses jason.planted.unheard; this"
        }
    }

    /**
     * Records [steps] that cannot be replayed, for the reason [why]. The steps before are replayed, and the log and the replay name the
     * reason.
     */
    fun shouldBeRefusedThere(steps: String, why: String, ending: String = "a replay without --check ends there") {
        val (file, log) = logged { recorded("!start. +!start <- +before; .wait(50); $steps; .print(done).") { after(1.seconds) } }
        log.single { line -> "ends there" in line } shouldBe "argo_record: $why; $ending"
        val outcome = replayOf(file)
        outcome.differences.shouldBeEmpty()
        outcome.refusals.single().why shouldStartWith why
        outcome.cycles shouldBeGreaterThan 0L
        outcome.cycles shouldBeLessThan outcome.recorded.toLong()
    }

    test("an action of the project that has a thread resume its intention; --check carries it out again") {
        shouldBeRefusedThere("planted.counts(N); .print(N)", "the project's action planted.counts has a thread resume its intention")
        shouldReplay(recorded("!start. +!start <- planted.counts(N); .print(N).") { after(1.seconds) }, isChecking = true)
    }

    test("a thread of the project that adds a belief") {
        shouldBeRefusedThere("planted.tells; .wait(20)", "a thread of the project has changed what agent agent believes")
    }

    test("an action of the project that adds a belief besides its result") {
        shouldBeRefusedThere("planted.believes", "the project's action planted.believes changes the agent besides its result")
    }

    test("work that the project leaves for the next cycle, and that adds a belief") {
        val (file, log) = logged { recorded("!start. +!start <- +before; .wait(50); planted.afterwards; .wait(50).") { after(1.seconds) } }
        log.single { line -> "ends there" in line } shouldContain Regex("work that the thread .* left has changed the agent")
        replayOf(file).run { differences.map { it.what } + refusals.map { "refused" } } shouldBe listOf("refused")
    }

    test("but not work that changes nothing of the agent, which a replay leaves out") {
        val (file, log) = logged { recorded("!start. +!start <- planted.later; .wait(50); .print(done).") { after(1.seconds) } }
        log.filter { line -> "argo_record" in line }.shouldBeEmpty()
        val before = planted.later.DONE.get()
        shouldReplay(file)
        planted.later.DONE.get() shouldBe before
        shouldReplay(file, isChecking = true)
        planted.later.DONE.get() shouldBe before + 2
    }

    test("an action of the project that sends a message besides its result") {
        shouldBeRefusedThere("planted.reports", "the project's action planted.reports sends a message besides its result")
    }

    test("a Java object that an action of the project gives") {
        shouldBeRefusedThere(
            "planted.today(T); .print(T)",
            "agent agent got a Java object of the class java.util.Date, which a recording cannot hold", "a replay ends there",
        )
    }

    test("a loop that goes on with results of an action in later cycles") {
        shouldBeRefusedThere(
            "for (planted.ways(X)) { .wait(20) }",
            "a loop goes on with results of planted.ways from an earlier cycle", "a replay ends there",
        )
    }

    test("an agent whose recording has ended keeps no event that a thread adds later") {
        val file = recordingFile()
        val ended = AtomicReference<TransitionSystem>()
        ControlledArch.live = ended::set
        try {
            agentOf("""!start. +!start <- .add_plan("+!x(X) <- jason.planted.unheard(X)."); .wait(50); !x(X); .print(X).""") {
                arch = ::ControlledArch
                options("argo_record" to "$file")
            }.use {
                it.after(300.milliseconds)
                it.log.single { line -> "runs without a recording" in line } shouldContain "jason.planted.unheard"
                val events = List(3) { byThread(ended.get()) }
                it.after(3.seconds)
                eventually(60.seconds) {
                    System.gc()
                    events.first().get() shouldBe null
                }
            }
        } finally {
            ControlledArch.live = {}
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
                it.log.single { line -> "runs without a recording" in line } shouldContain
                    "the program uses jason.planted.unheard; this version"
            }
        }
    }
})
