package argo.recording

import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.Replay
import argo.recording.replay.WhatIf
import argo.recording.why.Question
import argo.recording.why.Why
import argo.testkit.replayed
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds

/** A recording without its beginning is replayed from a key frame on. Recordings of the last minutes have no beginning. */
class KeyFramesSpec : FunSpec({
    /** Records twelve seconds of [program], and keeps the last three. */
    fun ring(program: String, kept: (String, String) -> String? = { _, text -> text }): Path = ringOf(
        recorded(program) {
            repeat(24) {
                perceives("dist(front,${30 + it * 7 % 50})", "light(back,140)", """name("a \"b\"")""")
                after(500.milliseconds)
            }
        },
        Duration.ofSeconds(3), kept,
    )

    fun beliefsAfter(file: Path, agent: String = "agent"): List<String> = Recording(file).use { recording ->
        Replay(recording).use { replay ->
            replay.run()
            withClue(replay.differences.joinToString("\n")) { replay.differences.shouldBeEmpty() }
            replay.cyclesRun shouldBeGreaterThan 5L
            replay.beliefs(agent)
        }
    }

    fun shouldReplay(program: String) {
        val ring = ring(program)
        Recording(ring).use { recording ->
            recording.cycles("agent").first().index shouldBeGreaterThan 1L
            recording.start("agent").shouldNotBeNull()
        }
        beliefsAfter(ring) shouldBe beliefsAfter(ring.resolveSibling("drive.mcap"))
        Recording(ring).use { recording ->
            WhatIf(recording, "agent").use { it.run().difference(Duration.ZERO).shouldBeNull() }
        }
    }

    val reacting = """
        limit(40). seen(0)[kind(count),source(self)].
        near(Cm) :- limit(L) & Cm < L.
        !start.
        +!start <- argo.port(ttyACM0); argo.percepts(open).
        +dist(front,Cm) : near(Cm) & seen(N) <- -+seen(N+1)[kind(count)]; +passed(N)[at(Cm)]; argo.act(stop).
        +dist(front,Cm) <- argo.act(forward); .print(Cm).
    """.trimIndent()

    test("an agent that rests between its percepts, with rules and annotated beliefs") { shouldReplay(reacting) }

    test("an agent that always waits: for a time, for a belief, for an event") {
        shouldReplay(
            """
            !start. !watch. !hear(0).
            +!start <- argo.port(ttyACM0); argo.percepts(open); !on(1).
            +!on(N) <- argo.act(led(N)); .wait(70); !off(N).
            +!off(N) <- .wait(30); !on(N+1).
            +!watch <- .wait(dist(front,Cm) & Cm < 45, 1500); .print(near, Cm); .wait(dist(front,D) & D > 45, 1500); !watch.
            -!watch[error(E)] <- .print(E); !!watch.
            +!hear(N) <- .wait({+dist(front,Cm)}); .print(heard, Cm, N); !hear(N+1).
            """.trimIndent(),
        )
    }

    test("branches, loops, goals within goals and what variables are bound to") {
        shouldReplay(
            """
            !start.
            +!start <- argo.port(ttyACM0); argo.percepts(open); N = 7; Name = "a \"b\" \\ c"; !outer(N, [1,x|[f(Y)]], Name); .print(Y, N).
            +!outer(N, L, S) <-
                while (not finished) {
                    .wait(40);
                    if (dist(front,Cm) & Cm < 45) { !inner(Cm, Z); .print(Z, S); .wait(20) } else { .random(R); +drew(R); .wait(60); .abolish(drew(_)) };
                    .print(L)
                }.
            +!inner(Cm, Z) <- .wait(50); Z = g(Cm, _); ?light(B, V); .print(B, V).
            """.trimIndent(),
        )
    }

    test("plans that were added and removed, suspended and atomic intentions, and a question that nobody answers") {
        shouldReplay(
            """
            !start. !ask. !idle.
            +!start <- argo.port(ttyACM0); argo.percepts(open);
               .add_plan({ @added +!step(N) <- .wait(60); .print(added, N); !turn(N) }); .remove_plan(removed); .suspend(idle); !step(1).
            @removed +!turn(N) <- .print(never).
            @turn[atomic] +!turn(N) <- -+count(N); .print(N); !!step(N+1).
            +!ask <- .send(nobody, askOne, price(X), A); .print(A).
            +!idle <- .wait(100); .print(idle); !idle.
            """.trimIndent(),
        )
    }

    test("an agent that is never at a place that can be described, and why") {
        val file = ring(
            """
            !start.
            +!start <- argo.port(ttyACM0); argo.percepts(open); !round.
            +!round <- for (.range(I, 1, 1000000)) { .wait(100) }; !round.
            """.trimIndent(),
        )
        val message = shouldThrow<RecordingException> { replayOf(file) }.message.orEmpty()
        message shouldContain "begins with its cycle"
        message shouldContain "argo_record=\"last(10)\""
        message shouldContain "a loop \"for\""
    }

    test("an agent that believes a Java object, which no key frame can hold") {
        val file = ring(
            """
            !start.
            +!start <- planted.today(T); +held(T); argo.port(ttyACM0); argo.percepts(open).
            +dist(front,Cm) <- .print(Cm).
            """.trimIndent(),
        )
        shouldThrow<RecordingException> { replayOf(file) }.message.orEmpty() shouldContain
            "a belief held a Java object of the class java.util.Date"
    }

    test("a ring without a key frame") {
        val file = ring(reacting) { topic, text -> text.takeUnless { topic.endsWith("/keyframe") } }
        shouldThrow<RecordingException> { replayOf(file) }.message.orEmpty() shouldContain "no key frame to begin with; keep more minutes"
    }

    test("a key frame that is damaged").config(tags = thorough) {
        val damages = listOf<(String) -> String>(
            { it.replace(Regex("\"mind\":\"...."), "\"mind\":\"!!!!") },
            { it.replace("\"mind\":\"eJ", "\"mind\":\"eK") },
            { it.replace(Regex(""""mind":"[^"]*""""), """"mind":""""") },
            { it.replace(Regex(""""parts":\d+"""), """"parts":3""") },
            { it.replace("dist(front,", "dist((front,") },
            { it.replace(Regex(""""percepts":\[\d+"""), """"percepts":[9999""") },
        )
        for (damage in damages) {
            val file = ring(reacting) { topic, text -> if (topic.endsWith("/keyframe")) damage(text) else text }
            shouldThrow<RecordingException> { replayOf(file) }.message.orEmpty() shouldContain "key frame"
        }
    }

    test("two agents that talk begin each at its own key frame") {
        val file = recordingFile()
        val folder = file.parent
        folder.resolve("talk.mas2j").writeText("MAS talk { agents: left agentArchClass argo.Arch; right agentArchClass argo.Arch; }")
        folder.resolve("left.asl").writeText(
            """
            !ask(0).
            +!ask(N) <- .send(right, askOne, price(P), A); .print(A); .wait(130); .send(right, tell, asked(N)); !ask(N+1).
            """.trimIndent(),
        )
        folder.resolve("right.asl").writeText(
            """
            price(1).
            !rise.
            +!rise : price(P) <- .wait(170); -+price(P+1); .send(left, tell, risen(P)); !rise.
            +asked(N)[source(A)] <- .print(N, A).
            """.trimIndent(),
        )
        SeededDrives("$folder/talk.mas2j", listOf("left", "right")) { board("sim:none") { sensor("idle(%d)", 0..1) } }.record(1, file)
        val ring = ringOf(file, Duration.ofSeconds(6)) // a key frame is written every five seconds
        Recording(ring).use { recording ->
            val starts = recording.agents.keys.associateWith { agent ->
                withClue(recording.keyFrames(agent).map { "${it.ns}: ${it.missing}" }.toList()) { recording.start(agent).shouldNotBeNull() }
            }
            starts.keys shouldBe setOf("left", "right")
            recording.agents.keys.flatMap { agent -> recording.replayable(agent).flatMap { it.input.mail }.toList() }.shouldNotBeEmpty()
        }
        for (agent in listOf("left", "right")) beliefsAfter(ring, agent) shouldBe beliefsAfter(file, agent)
    }

    test("why, and what if, of what is left") {
        val file = ring(reacting.replace("near(Cm) & seen", "Cm < 40 & seen"))
        Recording(file).use { recording ->
            Why(recording).use { why ->
                val last = Question("stop").find(why.commands)
                val answer = why.answer(last)
                answer.cause.shouldNotBeNull().plan.trigger shouldContain "+dist(front,"
                answer.frame.shouldNotBeNull()
                answer.had.map { it.percept to it.isSent } shouldContain ("dist(front,40)" to false)
                why.had(last, "dist(front,41)").isSent shouldBe false
                val lost = why.commands.first()
                shouldThrow<RecordingException> { why.answer(lost) }.message.orEmpty() shouldContain "it can be replayed from"
            }
        }
    }

    test("another program on what is left") {
        val file = ring(reacting)
        val changed = file.resolveSibling("changed.asl").apply { writeText(reacting.replace("argo.act(stop)", "argo.act(halt)")) }
        replayed("$file", program = "${file.resolveSibling("agent.asl").apply { writeText(reacting) }}").shouldSendTheSame()
        shouldThrow<AssertionError> { replayed("$file", program = "$changed").shouldSendTheSame() }.message.orEmpty() shouldContain "halt"
    }
})

private val thorough = setOf(NamedTag("Thorough"))
