package argo.view.timeline

import argo.recording.replay.Recording
import argo.testkit.agentOf
import argo.testkit.mas
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

class TimelineSpec : FunSpec({
    val file = tempdir().toPath().resolve("drive.mcap")
    agentOf(DRIVER) { options("argo_record" to "$file") }.use { robot ->
        robot.perceives("dist(front,80)")
        robot.after(1.seconds)
        robot.perceives("dist(front,30)")
        robot.shouldSend("stop")
        robot.after(300.milliseconds)
        robot.board.disconnects()
        robot.after(1.seconds)
    }
    val timeline = Recording(file).use(Timeline::of)
    fun items(lane: Lane) = timeline.items.filter { it.lane == lane }
    fun related(item: Item) = checkNotNull(timeline.related(item.id, 100))
    fun command(text: String) = items(Lane.COMMANDS).first { it.text == text }

    test("a command came of the step of an intention, that of an event, that of percepts, and these of a message of the board") {
        val causes = related(command("stop")).causes
        causes.map { it.lane } shouldBe listOf(Lane.INTENTIONS, Lane.EVENTS, Lane.PERCEPTS, Lane.LINE)
        causes[0].text shouldBe "argo.act(stop)"
        causes[0].detail.first() shouldContain "line 6"
        causes[1].text shouldStartWith "+dist(front,30)"
        causes[3].detail.first() shouldContain "dist(front,30)"
    }

    test("a message came of the step that sent it, also in the recording of another program, whose clock differs") {
        val (base, scout) = listOf("base", "scout").map { tempdir().toPath().resolve("$it.mcap") }
        mas {
            agentOf("base", "+wall(D).") { options("argo_record" to "$base") }
            agentOf("scout", "!look. +!look <- .wait(500); .send(base, tell, wall(3)).") { options("argo_record" to "$scout") }
        }.use { it["base"].shouldBelieve("wall(3)[source(scout)]") }
        fun joint(aheadNs: Long) =
            Recording(base).use { one -> Recording(scout).use { Timeline.ofAll(listOf(one, it), listOf(0, aheadNs)) } }
        joint(0).run {
            agents shouldBe listOf("base", "scout")
            val message = items.single { it.text == "tell of scout: wall(3)" }
            items[message.causes.single()].run { agents[agent] to text } shouldBe ("scout" to ".send(base,tell,wall(3))")
        }
        val (early, late) = listOf(joint(0), joint(-1_000_000_000)).map { one -> one.items.last { it.agent == 1 }.from }
        late - early shouldBe 1.0.plusOrMinus(1e-6)
    }

    test("and of a goal, which a step of another plan has posed") {
        val causes = related(command("forward")).causes
        causes.map { it.text } shouldBe listOf("argo.act(forward)", "+!drive", "!drive", "+!start")
    }

    test("what came of a message of the board is found the other way round") {
        val effects = related(items(Lane.LINE).first { "dist(front,30)" in it.detail.first() }).effects
        effects.map { it.text } shouldContainAll listOf("argo.act(stop)", "stop", "stop to ttyACM0")
    }

    test("a command lasts until its outcome, and one that failed stands out") {
        val stop = command("stop")
        stop.from shouldBeLessThan checkNotNull(stop.until)
        stop.isBad shouldBe false
        val failed = items(Lane.COMMANDS).last()
        failed.isBad shouldBe true
        failed.detail.joinToString() shouldContain "failed after"
        items(Lane.EVENTS).find { it.text.startsWith("-!horn") }?.let { timeline.items[it.causes.single()].text } shouldBe "argo.act(horn)"
    }

    test("printed lines have the step that printed them") {
        items(Lane.PRINTED).single().run {
            text shouldBe "near"
            timeline.items[causes.single()].text shouldBe ".print(near)"
        }
    }

    test("what is seen alone is sent, bars that began before too, and too many items as heaps") {
        val stop = command("stop")
        val seen = timeline.between(stop.from, stop.from + 0.05, 100).flatMap { it.items }
        seen.map { it.id } shouldContain stop.id
        seen.size shouldBeLessThan timeline.items.size
        timeline.between(stop.from - 1e-6, stop.from - 1e-9, 100).flatMap { it.items }.map { it.text } shouldBe emptyList()
        val part = timeline.between(0.0, timeline.seconds, 2).first { it.lane == Lane.EVENTS }
        part.items.shouldBeEmpty()
        part.heaps.sumOf { it.count } shouldBe items(Lane.EVENTS).size
    }

    test("the next item of a lane, and none behind the last") {
        val (first, second) = items(Lane.COMMANDS)
        timeline.beside(first.id, isAfter = true) shouldBe second.id
        timeline.beside(second.id, isAfter = false) shouldBe first.id
        items(Lane.COMMANDS).last().run { timeline.beside(id, isAfter = true) shouldBe id }
        timeline.related(-1, 10) shouldBe null
        timeline.related(first.id, 1)!!.causes shouldHaveSize 1
    }
})

private val DRIVER = """
    !start.
    +!start <- argo.port(ttyACM0); argo.percepts(open); !drive.
    +!drive <- .wait(20);
       argo.act(forward).
    +dist(front,Cm) : Cm < 50
       <- argo.act(stop);
          .print(near); !horn.
    +!horn <- .wait(900); argo.act(horn).
    -!horn.
    +port(_,_).
""".trimIndent()
