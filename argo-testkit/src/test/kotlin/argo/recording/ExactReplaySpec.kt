package argo.recording

import argo.Arch
import argo.platform.Platform
import argo.recording.replay.Recording
import argo.recording.replay.Replay
import argo.recording.why.Question
import argo.recording.why.StepCause
import argo.recording.why.Why
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.asSyntax.ASSyntax
import jason.asSyntax.Atom
import jason.asSyntax.Literal
import jason.asSyntax.LiteralImpl
import jason.asSyntax.NumberTermImpl
import jason.asSyntax.ObjectTermImpl
import jason.asSyntax.SetTermImpl
import jason.asSyntax.Structure
import jason.asSyntax.Term
import jason.environment.Environment
import java.util.Date
import java.util.concurrent.CopyOnWriteArrayList
import java.util.logging.Handler
import java.util.logging.LogRecord
import java.util.logging.Logger
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** A replay gives an agent all its recorded inputs at the recorded times. */
class ExactReplaySpec : FunSpec({
    fun percept(functor: String, vararg terms: Term): Literal = LiteralImpl(functor).addTerms(*terms)

    fun number(value: Double) = NumberTermImpl(value)

    fun world(vararg percepts: Literal) = Environment().apply { addPercept(*percepts) }

    test("percepts of an environment whose terms Jason's syntax has not, or has with another meaning") {
        val world = world(
            percept("temp", number(-1.0)), percept("way", ASSyntax.createList(number(1.0), number(-2.0))), LiteralImpl("Upper Case"),
            percept("at", Structure("Pos").addTerms(number(1.0), number(-2.0)), Atom("Upper Case")),
            Structure("unbelievable", 1), Atom("never"),
            percept("Height", number(1e300)), percept("none", number(Double.NaN)), percept("far", number(Double.POSITIVE_INFINITY)),
            percept("says", ASSyntax.createString("C:\\temp \"x\"\n")), percept("seen", SetTermImpl().apply { add(Atom("Cup")) }),
            ASSyntax.parseLiteral("lab::~door(open)[by(-3)]"),
        )
        shouldReplay(
            recorded(
                """
                +temp(T) <- .print(T).
                +at(P, C) <- .print(P, C).
                +way(L) <- .print(L); .nth(1, L, X); -+last(X); !go(X).
                +!go(X) : X < 0 <- .print(back, X).
                +none(N) : N \== N <- .print(N).
                +says(S) <- .length(S, N); .print(S, N).
                +seen(S) <- .set.add(S, plate); .print(S).
                +lab::~door(D)[by(X)] <- .print(D, X).
                """.trimIndent(),
                { environment = world },
            ) { after(1.seconds) },
        )
    }

    test("goals with variables that are not bound, and questions about them") {
        shouldReplay(
            recordedMas(
                "clerk" to """
                    !get(_, Task, _).
                    +!get(Id, Task, Prices)[source(S)] <- .print(Id, Task, Prices); !find(Id, _, Prices).
                    +!find(_, _, Prices) <- .send(store, askOne, item(_, Price, Rest), A);
                       .print(A, Price, Rest); ?item(N, P, _); .print(N, P).
                    +?item(pen, 2, L) <- .length([L], N).
                """,
                "store" to "item(cup, -4, [X|T]). item(plate, 3, []).",
            ) { after(1.seconds) },
        )
    }

    test("messages about what is not, of terms that look like others, and those behind them") {
        shouldReplay(
            recordedMas(
                "lodger" to """
                    !start.
                    +!start <- .send(porter, achieve, ~locked(door)); .send(porter, tell, ~hello(-1)); .send(porter, tell, hello(1));
                       .send(porter, achieve, rest); .send(porter, tell, lab::at([1,-2|_])); .send(porter, untell, ~hello(-1));
                       .send(porter, signal, ring(2)).
                """,
                "porter" to """
                    +!~locked(D)[source(S)] <- .print(open, D, S).
                    +!rest[source(S)] <- .print(S).
                    +hello(N)[source(S)] <- .print(N, S).
                    +~hello(N) <- .print(no, N).
                    -~hello(N) <- .print(gone, N).
                """,
            ) { after(1.seconds) },
        )
    }

    test("agents that an execution control runs, which hear by plans what others believe at once") {
        val file = recordedBy { ts -> ts.settings.isSync = true }
        Recording(file).use { it.cycles("agent").mapNotNull { cycle -> cycle.course.event }.toList() }.first { "hello" in it } shouldContain
            "kqml_received"
        shouldReplay(file, isChecking = true) // the agent's architecture is code of the project
    }

    test("beliefs and goals whose values are drawn when Jason reads the program") {
        val program =
            """
            luck(math.random(100)). t0(system.time). sum(math.random(3) + 1)[since(system.time)].
            !p(system.time). !q(math.random(100), 1 - 3).
            double(X) :- luck(Y) & X = Y * 2.
            +luck(L) <- .print(L).
            +!p(T) : t0(T0) <- .print(T, T0).
            +!q(X, Y) : double(D) <- .print(X, Y, D).
            """.trimIndent()
        val file = recorded(program) { after(1.seconds) }
        shouldReplay(file)
        val beliefs = { Recording(file).use { recording -> Replay(recording).use { it.run().beliefs("agent") } } }
        beliefs() shouldBe beliefs()
        beliefs().count { it.startsWith("luck(") } shouldBe 1
    }

    test("a hundred messages of one agent, of which some say the same, without plans for them") {
        val file = recordedMas(
            "speaker" to """
                !start.
                +!start <- for (.range(I,1,100)) { .send(hearer, tell, v(I)) }; .send(hearer, tell, w(1)); .send(hearer, tell, w(1));
                   .send(hearer, tell, w(3)).
            """,
            "hearer" to "+w(N) <- .count(v(_), C); .print(N, C).",
        ) { after(1.seconds) }
        Recording(file).use { it.cycles("hearer").last() }.course.printed.last() shouldBe "3100"
        shouldReplay(file)
    }

    test("an agent that perceives in each third cycle only") {
        shouldReplay(
            recorded(
                "!count(0). +!count(N) : N < 20 <- .wait(30); !count(N + 1). +!count(_). +dist(_,Cm) <- .print(Cm).",
                { options("nrcbp" to "3", "argo_sensing" to "every") },
            ) {
                hears("boss", "tell", "a(1)")
                after(100.milliseconds)
                repeat(5) { hears("boss", "tell", "note($it)") }
                after(1.seconds)
            },
        )
    }

    test("questions with a time limit that are answered late, never, by several, and with plans") {
        shouldReplay(
            recordedMas(
                "asker" to """
                    !start.
                    +!start <- .send(slow, askOne, price(cup, _), A, 100); .print(A); .wait(600);
                       .send([slow, quick, nobody], askOne, price(_, _), B, 2000); .print(B);
                       .send(quick, askAll, price(_, _), C, 500); .print(C); .send(quick, askHow, {+!sell(_, _)}, D, 500); .print(D);
                       .add_plan(D); !sell(cup, 1); .send(quick, askOne, ~price(cup, X), E); .print(E, X).
                    -!start[error(Why), error_msg(M)] <- .print(Why, M).
                """,
                "slow" to "+?price(Thing, P) <- .wait(400); P = -3.",
                "quick" to "price(cup, -1). price(plate, 2)[kind(flat)]. ~price(cup, 7). +!sell(Thing, _) <- .random(R); .print(Thing, R).",
            ) { after(5.seconds) },
        )
    }

    test("waits for events and beliefs with a time limit, and goals at a time") {
        shouldReplay(
            recorded(
                """
                !start. !later.
                +!start <- .wait({+go(_)}, 200, T); .wait(ready, 100).
                -!start[error(E)] <- .print(E); .wait(ready & not busy); .print(on).
                +!later <- .at("now +300 milliseconds", {+!ring(-1)}); .at("now +1 second", {+busy}).
                +!ring(N) <- .print(N); +ready.
                """.trimIndent(),
            ) { after(3.seconds) },
        )
    }

    test("events that another thread puts into the queue in the middle of a cycle") {
        val file = recorded("!start. +!start : planted.rings <- !more; planted.rings; !more. +!more <- +more. +ring(N) <- .print(N).") {
            after(1.seconds)
        }
        Recording(file).use { it.cycles("agent").flatMap { cycle -> cycle.input.events }.toList() } shouldBe listOf("+ring(1)", "+ring(1)")
        shouldReplay(file)
    }

    test("an event that another thread puts into the queue, and for which an intention waits") {
        val (file, log) = logged {
            recorded("!start. !ring. +!start <- .wait({+ring(N)}); .print(heard). +!ring <- .wait(50); planted.rings; .print(rung).") {
                after(1.seconds)
            }
        }
        log.filter { "ends there" in it }.shouldBeEmpty()
        shouldReplay(file)
    }

    test("plans that are added while the agent runs, with chance and functions in them") {
        shouldReplay(
            recorded(
                """
                !start.
                +!start <- .add_plan("@new +!roll(X) : Y = math.random(6) <- .random(R); .print(X, Y, R).");
                   .add_plan({ @other +!turn(X) <- Z = math.random(X); .print(Z) }); !roll(1); !turn(9); .remove_plan(other);
                   .relevant_plans({+!roll(_)}, Ps); .print(Ps); .plan_label(P, new); .print(P).
                """.trimIndent(),
            ) { after(1.seconds) },
        )
    }

    test("goals that are suspended and resumed, and dropped by name") {
        shouldReplay(
            recorded(
                """
                !start.
                +!start <- for (.range(I, 1, 12)) { !!job(I) }; .wait(50); .resume(job(7)); .resume(job(_)); .wait(20);
                   .drop_desire(job(3)); .succeed_goal(job(4)); .print(done).
                +!job(N) <- .suspend; .wait(N * 10); .print(N).
                """.trimIndent(),
            ) { after(1.seconds) },
        )
    }

    test("a Java object in a percept or a message is refused by its name, where it comes") {
        val (file, log) = logged {
            recorded("+clock(C) <- .print(C).", { environment = world(percept("clock", ObjectTermImpl(Date(0)))) }) { after(1.seconds) }
        }
        log.single { "cannot hold" in it } shouldBe "argo_record: agent agent got a Java object of the class java.util.Date, " +
            "which a recording cannot hold; a replay ends there"
        val outcome = replayOf(file)
        outcome.differences.shouldBeEmpty()
        outcome.refusals.single().why shouldBe "agent agent got a Java object of the class java.util.Date, which a recording cannot hold"
    }

    for (split in listOf("|&|", "|||")) {
        test("why follows an intention that was split by $split") {
            val file = recorded(
                """
                !start.
                +!start <- argo.port(ttyACM0); argo.percepts(open).
                +dist(front,Cm) : Cm < 40 <- !brake(1) $split !warn; argo.act(stop).
                +!brake(N) <- argo.act(slow(N)).
                +!warn <- argo.act(horn).
                """.trimIndent(),
            ) {
                perceives("dist(front,80)")
                after(1.seconds)
                perceives("dist(front,30)")
                after(2.seconds)
            }
            Recording(file).use { recording ->
                Why(recording).use { why ->
                    for (command in listOf("slow(1)", "stop")) {
                        val cause = why.answer(Question.of(command).shouldNotBeNull().find(why.commands)).cause.shouldNotBeNull()
                        val plans = generateSequence(cause.plan) { (it.event as? StepCause)?.plan }
                        plans.map { it.trigger }.toList() shouldContain "+dist(front,30)"
                    }
                }
            }
        }
    }
})

/** Records an agent with the infrastructure calls in [live]. The replay has no such calls. */
private fun recordedBy(live: (jason.asSemantics.TransitionSystem) -> Unit) = try {
    ControlledArch.live = live
    recorded("+hello(N) <- .print(N).", { arch = ::ControlledArch }) {
        hears("boss", "tell", "hello(1)")
        after(1.seconds)
    }
} finally {
    ControlledArch.live = {}
}

internal fun <T> logged(work: () -> T): Pair<T, List<String>> {
    val texts = CopyOnWriteArrayList<String>()
    val handler = object : Handler() {
        override fun publish(record: LogRecord) {
            texts += record.message
        }

        override fun flush() = Unit

        override fun close() = Unit
    }
    val log = Logger.getLogger(Arch::class.java.name).apply { addHandler(handler) }
    try {
        return work() to texts
    } finally {
        log.removeHandler(handler)
    }
}

/** An architecture that calls [live] before the agent runs. */
class ControlledArch(platform: Platform) : Arch(platform) {
    override fun init() {
        live(ts)
        super.init()
    }

    companion object {
        /** The calls of the infrastructure; none in a replay. */
        var live: (jason.asSemantics.TransitionSystem) -> Unit = {}
    }
}
