package argo.recording.why

import argo.observing.Order
import argo.recording.ordered
import argo.recording.recorded
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf
import kotlin.time.Duration.Companion.seconds

private val thorough = setOf(NamedTag("Thorough"))

class WhySpec : FunSpec({
    val driving = """
        !start.
        +!start <- argo.port(ttyACM0); argo.percepts(open); argo.act(forward).
        +dist(front,Cm) : Cm < 40 & not stopped & light(_,L) & L > 100 <- +stopped; argo.act(stop).
    """.trimIndent()

    fun <T> whyOf(program: String, setUp: AgentSetUp.() -> Unit = {}, drive: TestAgent.() -> Unit, ask: Why.() -> T): T =
        Recording(recorded(program, setUp, drive)).use { recording -> Why(recording).use { it.ask() } }

    fun Why.answer(question: String) = answer(Question.of(question).shouldNotBeNull().find(commands))

    fun <T> driven(ask: Why.() -> T): T = whyOf(driving, drive = {
        perceives("dist(front,80)", "light(back,140)")
        after(1.seconds)
        perceives("dist(front,30)", "light(back,140)")
        after(1.seconds)
    }, ask = ask)

    test("the frame, the plan and the step behind a command") {
        val answer = driven { answer("stop") }
        val cause = answer.cause.shouldNotBeNull()
        cause.step shouldBe "argo.act(stop)"
        cause.line shouldBe 3
        cause.plan.place.line shouldBe 3
        cause.plan.trigger shouldBe "+dist(front,30)"
        answer.frame.shouldNotBeNull().texts shouldBe listOf("dist(front,30)", "light(back,140)")
        answer.frames.map { it.texts.first() } shouldBe listOf("dist(front,30)", "dist(front,80)")
    }

    test("with which value of the percept it would not have been") {
        driven { answer("stop") }.had.map { it.percept to it.isSent } shouldBe listOf("dist(front,40)" to false, "light(back,100)" to false)
    }

    test("what it would have done with a percept that is asked about") {
        driven {
            val stop = Question("stop").find(commands)
            had(stop, "dist(front,41)").isSent shouldBe false
            had(stop, "dist(front,39)").isSent shouldBe true
        }
    }

    test("a goal of the program has no percept") {
        val answer = driven { answer("forward") }
        answer.frame shouldBe null
        answer.cause.shouldNotBeNull().root() shouldBe BeginningCause("start", "agent.asl", 1)
    }

    test("a belief whose step is forgotten among ten thousand others is not said to be from the beginning").config(tags = thorough) {
        val answer = whyOf(
            """
            !start.
            +!start <- +old; argo.port(ttyACM0); for (.range(I,1,11)) { for (.range(J,1,1000)) { +note(I,J) }; .wait(10) }; !go.
            +!go : old <- argo.act(stop).
            """.trimIndent(),
            drive = { shouldSend("stop", within = 60.seconds) },
        ) { answer("stop") }
        val cause = answer.cause.shouldNotBeNull().plan.conditions.single().causes.single()
        cause.shouldBeInstanceOf<UnknownCause>().why shouldContain
            "it was there from the beginning, or plans have noted more than 10000 beliefs"
    }

    test("a message of another agent") {
        val answer = whyOf(
            "!start.\n+!start <- argo.port(ttyACM0).\n+!go(N)[source(S)] <- argo.act(go(N)).",
            drive = {
                after(1.seconds)
                hears("boss", "achieve", "go(3)")
                after(1.seconds)
            },
        ) { answer("go(3)") }
        val message = answer.cause.shouldNotBeNull().root() as MessageCause
        message.copy(id = "") shouldBe MessageCause("boss", "achieve", "go(3)", answer.command.seconds)
    }

    test("a person set a belief, and began a goal") {
        val answer = whyOf(
            "!start.\n+!start <- argo.port(ttyACM0).\n+!go(N) : limit(L) & N < L <- argo.act(go(N)).",
            drive = {
                after(1.seconds)
                ordered(Order.Believe("limit(20 + 10)"))
                ordered(Order.Begin("!go(3)"))
                after(1.seconds)
            },
        ) { answer("go(3)") }
        val plan = answer.cause.shouldNotBeNull().plan
        plan.event.shouldBeInstanceOf<OrderCause>().run { kind to text } shouldBe ("begin" to "!go(3)")
        plan.conditions.first().causes.single().shouldBeInstanceOf<OrderCause>().run { kind to text } shouldBe
            ("believe" to "limit(20 + 10)")
    }

    test("the condition that failed, with its value") {
        val plan = driven { not("agent", Question("stop", 1.2)) }.plans.single()
        plan.verdict shouldBe Verdict.NOT_APPLICABLE
        plan.event shouldBe "+dist(front,80)"
        plan.conditions.last() shouldBe Condition("Cm < 40", "80 < 40", false)
    }

    test("a plan that was chosen is not asked about as if it were not") {
        driven { not("agent", Question("stop")) }.plans.single().verdict shouldBe Verdict.ISSUED
    }

    test("an event that never came, and what the filter dropped") {
        val program = """
            !start.
            +!start <- argo.port(ttyACM0); argo.change_filter(quiet); argo.percepts(open).
            +number(N) <- argo.act(count).
            +dist(_,_) <- !never(1).
            +!never(N) : N > 1 <- !count.
            +!count <- argo.act(count).
        """.trimIndent()
        val plans = whyOf(program, drive = { perceives("dist(front,3)", "number(1)") }) { not("agent", Question("count")) }.plans
        plans.map { it.verdict } shouldBe listOf(Verdict.NO_EVENT, Verdict.NO_EVENT)
        plans[0].missed.single().text shouldBe "number(1)"
        plans[1].above.single().run { verdict to conditions.last().value } shouldBe (Verdict.NOT_APPLICABLE to "1 > 1")
    }

    test("a wrong counterfactual is seen: what is stated is what the replay did") {
        driven {
            val stop = Question("stop").find(commands)
            for (value in 31..45) had(stop, "dist(front,$value)").isSent shouldBe (value < 40)
        }
    }

    test("questions") {
        Question.of("stop@12.3s") shouldBe Question("stop", 12.3)
        Question.of("speed(1,2)@4") shouldBe Question("speed(1,2)", 4.0)
        Question.of("stop#3") shouldBe Question("stop", count = 3)
        Question.of("stop") shouldBe Question("stop")
        Question.of(" ") shouldBe null
    }

    test("a command that was not sent is refused with those around it") {
        val refused = shouldThrow<RecordingException> { driven { answer("stop@0.4s") } }
        refused.message shouldContain "there is no command stop@0.4s; those around that time: forward@"
        shouldThrow<RecordingException> { driven { answer("stop#2") } }.message shouldContain "the last command stop is number 1"
    }
})
