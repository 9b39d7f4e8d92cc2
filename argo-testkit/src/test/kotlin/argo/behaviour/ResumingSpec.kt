package argo.behaviour

import argo.observing.Order
import argo.recording.ordered
import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import argo.testkit.agentOf
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.longs.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** An agent with `argo_resume` continues from the state that its last run saved. */
class ResumingSpec : FunSpec({
    var files = 0
    val root = tempdir().toPath()

    fun stateFile(): Path = root.resolve("${++files}").createDirectory().resolve("robot.state")

    fun robot(state: Path, program: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent = agentOf(program) {
        name = "robot"
        options("argo_resume" to "\"$state\"")
        setUp()
    }

    /** Runs an agent to its end, which saves its state. */
    fun kept(state: Path, program: String, setUp: AgentSetUp.() -> Unit = {}, drive: TestAgent.() -> Unit) {
        robot(state, program, setUp).use { it.apply(drive).stops() }
        state.exists() shouldBe true
    }

    val guard = """
        round(0). limit(40).
        !start.
        +!start <- argo.port(ttyACM0, [baud(115200), boot(0)]); argo.limit(20); argo.percepts(open); !!patrol(north).
        +!patrol(P) <- .wait(100); !step(P).
        +!step(P) : round(R) <- argo.act(go(R + 1)); -+round(R + 1); !patrol(P).
        +resumed(Ms) <- .print("away for ", Ms).
        +order(X)[source(S)] <- .print("order ", X).
    """

    test("its beliefs, its goals and its boards are as they were, and it knows that it has gone on") {
        val state = stateFile()
        kept(state, guard, { board.shows("dist(front,9)") }) {
            hears("boss", "tell", "order(tea)").after(1.seconds).shouldBelieve("round(R) & R > 5 & dist(front,9)")
        }
        val round = Regex("""(?m)^round\((\d+)\)""").find(state.readText())!!.groupValues[1].toInt()
        robot(state, guard, { board("ttyACM0").shows("dist(front,8)") }).use { robot ->
            robot.shouldBelieve("round($round)", 10.milliseconds).shouldBelieve("resumed(_)[source(self)] & order(tea)[source(boss)]")
            robot.shouldPrint("away for ").shouldSend("go(${round + 1})")
            robot.shouldBelieve("dist(front,8)").shouldNotBelieve("dist(front,9)", 0.seconds)
            robot.shouldIntend("patrol(north)").shouldNotIntend("start", 0.seconds)
            robot.printed.filter { "order" in it }.shouldBeEmpty()
            robot.stops()
        }
        val lines = state.readText().lines()
        lines shouldContain "argo.ports([port(ttyACM0,[baud(115200),boot(0)])])."
        lines shouldContain "argo.limit(20)."
        lines shouldContain "!patrol(north)[source(self)]."
        state.readText() shouldNotContain "dist("
        lines.filter { it.startsWith("resumed") }.shouldBeEmpty()
    }

    test("its goals begin when its boards are there; a port that is not is told, and tried again until it is there") {
        val state = stateFile()
        kept(state, guard) { after(1.seconds) }
        robot(state, guard, { board("ttyACM0").disconnects() }).use { robot ->
            robot.shouldBelieve("port(ttyACM0,off)").after(3.seconds)
            robot.log.count { "argo_resume" in it && "the goals wait for it" in it } shouldBe 1
            robot.board("ttyACM0").reconnects()
            robot.shouldBelieve("port(ttyACM0,on)", 2.seconds).shouldSend("go(20)", 10.seconds).shouldNotSend("go(5)", 0.seconds)
        }
    }

    test("what it believes while it waits for a board is kept, and so are its goals and its boards") {
        val state = stateFile()
        kept(state, guard) { after(1.seconds) }
        fun settings() = state.readText().lines().filter { it.startsWith("argo.") && "written" !in it }.sorted()
        val before = settings()
        robot(state, guard, { board("ttyACM0").disconnects() }).use { robot ->
            robot.after(1.seconds).hears("boss", "tell", "order(tea)").after(5.seconds)
            state.readText().lines() shouldContain "order(tea)[source(boss)]."
            state.readText() shouldContain "!patrol(north)[source(self)]."
            robot.stops()
        }
        settings() shouldBe before
        robot(state, guard).use { robot ->
            robot.shouldBelieve("resumed(_) & order(tea)[source(boss)]").shouldSend("go(10)", 10.seconds)
            robot.shouldIntend("patrol(north)", 0.seconds)
        }
    }

    test("its goals begin also if it chooses its port itself, because the one that it had is not there") {
        val state = stateFile()
        val program = "$guard\n+port(ttyACM0,off) <- argo.port(spare, [boot(0)])."
        kept(state, program) { after(1.seconds) }
        robot(state, program, { board("ttyACM0").disconnects() }).use { robot ->
            robot.shouldBelieve("port(spare,on)").shouldIntend("patrol(north)", 3.seconds)
            robot.after(1.seconds).sent.first() shouldBe "go(10)"
        }
    }

    test("what a message has begun begins anew, and what a percept has begun only with the percept") {
        val state = stateFile()
        val program = """
            !start.
            +!start <- argo.port(ttyACM0, [boot(0)]); argo.percepts(open).
            +order(X)[source(S)] <- .wait(100000); !fetch(X).
            +dist(f,X) <- !avoid.
            +!avoid <- .wait(100000).
        """
        kept(state, program, { board.shows("dist(f,3)") }) { hears("boss", "tell", "order(tea)").after(1.seconds) }
        robot(state, program, { board("ttyACM0").shows("dist(f,3)") }).use { robot ->
            robot.after(1.seconds).intentions shouldContainExactlyInAnyOrder
                listOf("order(tea) at .wait(100000)", "!avoid at .wait(100000) for dist(f,3) at !avoid")
        }
    }

    test("its filters, its intervals and whether it perceives are as they were, for each board") {
        val state = stateFile()
        val program = """
            !start.
            +!start <- argo.ports([left, port(right, [as(r)])]); argo.limit(30); argo.limit(70, [port(right)]);
                argo.change_filter(front); argo.change_filter(none, [port(right)]).
            +!look <- argo.percepts(open).
        """
        kept(state, program) { after(1.seconds) }
        state.readText().lines().filter { it.startsWith("argo.") && "written" !in it && "program" !in it } shouldBe listOf(
            "argo.ports([port(left,[baud(9600)]),port(right,[baud(9600),as(r)])]).", "argo.limit(30).", "argo.percepts(block).",
            "argo.change_filter(\"front\").", "argo.limit(70,[port(right)]).", "argo.change_filter(none,[port(right)]).",
        )
        robot(state, program, {
            board("left").shows("dist(f,1)", "temp(f,20)")
            board("right").shows("temp(f,30)")
        }).use { robot ->
            robot.after(1.seconds).shouldNotBelieve("dist(f,1)", 0.seconds)
            robot.hears("boss", "achieve", "look").shouldBelieve("dist(f,1) & r::temp(f,30)").shouldNotBelieve("temp(f,20)", 0.seconds)
        }
    }

    test("a changed program: its new beliefs and goals are there, its former ones are gone, a goal without a plan is told") {
        val state = stateFile()
        kept(state, "limit(40). count(0). !watch. +!watch <- -+count(3); .wait(100000).") { after(1.seconds) }
        robot(state, "limit(30). count(0). !hum. +!hum <- +hummed. +limit(L) <- .print(\"limit \", L).").use { robot ->
            robot.shouldBelieve("limit(30) & count(3) & hummed").shouldNotBelieve("limit(40) | count(0)", 0.seconds)
            robot.printed shouldBe listOf("limit 30")
            val log = robot.log.joinToString("\n")
            log shouldContain "by the changed program not believed any more: limit(40)[source(self)]"
            log shouldContain "!watch[source(self)] is not begun anew: the agent has no plan for it"
        }
    }

    test("a file that is broken is told, kept under another name, and the agent begins as its program says") {
        val state = stateFile()
        kept(state, guard) { after(1.seconds) }
        val broken = state.readText().dropLast(30).also(state::writeText)
        robot(state, guard).use { robot ->
            robot.shouldSend("go(1)").shouldNotBelieve("resumed(_)", 0.seconds)
            robot.log.single { "cannot be read" in it } shouldContain "it is cut off"
            robot.stops()
        }
        state.parent.listDirectoryEntries("robot.state.broken-*").single().readText() shouldBe broken
        state.readText() shouldContain "!patrol(north)"
    }

    test("a file that is no text is told so") {
        val state = stateFile()
        state.writeBytes(byteArrayOf(-1, -2))
        robot(state, guard).use { robot -> robot.log.single { "cannot be read" in it } shouldContain "it is no text in UTF-8" }
    }

    test("a call in the file that cannot be carried out is told, and the agent goes on with the others") {
        val state = stateFile()
        kept(state, guard) { after(1.seconds) }
        state.writeText(
            state.readText().replace("argo.limit(20).", "argo.limit(often).\nargo.fly(high).\nargo.change_filter(\"no such filter\")."),
        )
        robot(state, guard).use { robot ->
            robot.shouldBelieve("resumed(_)").shouldSend("go(10)", 10.seconds)
            val log = robot.log.filter { "argo_resume" in it }.joinToString("\n")
            log shouldContain "the sensing interval is a whole number"
            log shouldContain "argo.fly(high) is no call that sets boards up"
            log shouldContain "no such filter"
        }
    }

    context("it is told, and the agent begins as its program says and keeps nothing") {
        fun shouldRefuse(value: String, why: String) = agentOf("!start. +!start <- +begun.") {
            name = "robot"
            options("argo_resume" to value)
        }.use { robot -> robot.shouldBelieve("begun").log.single { "keeps nothing" in it } shouldContain why }

        test("if the option names a folder") { shouldRefuse("\"$root\"", "that is a folder") }
        test("if its folder is not there") { shouldRefuse("\"$root/none/robot.state\"", "there is no folder $root/none; make it") }
        test("if it names nothing") { shouldRefuse("\"\u0000\"", "that is no name of a file") }
        test("if another agent has the file") {
            val state = stateFile()
            robot(state, "!start. +!start.").use { shouldRefuse("\"$state\"", "another agent has this file") }
        }
    }

    test("a file that cannot be written is told once, and again when it can") {
        val state = stateFile()
        val blocked = state.resolveSibling("robot.state.new").createDirectory()
        robot(state, guard).use { robot ->
            robot.after(20.seconds).log.count { "cannot be written" in it } shouldBe 1
            blocked.toFile().delete()
            robot.after(5.seconds).log.count { "is written again" in it } shouldBe 1
        }
        state.exists() shouldBe true
    }

    test("a belief that no text can hold is left out, which is told once") {
        val state = stateFile()
        robot(state, "!start. +!start <- .queue.create(Q); +q(Q); +r(1).").use { robot ->
            robot.after(20.seconds).log.count { "robot.state does not keep q(" in it } shouldBe 1
        }
        state.readText().lines() shouldContain "r(1)[source(self)]."
        state.readText().lines().filter { it.startsWith("q(") }.shouldBeEmpty()
    }

    test("a name with a line break is left out, which is told once, and the agent goes on from all else") {
        val state = stateFile()
        kept(state, "r(1). !start. +!start <- +note('a\nb'); +note('c\rd'); .wait(100000). +!go('x\ny') <- .wait(100000).") {
            hears("boss", "achieve", "go('x\ny')").after(20.seconds)
            log.count { "robot.state does not keep note('a" in it } shouldBe 1
        }
        state.readText().lines().filter { it.startsWith("note") || it.startsWith("!go") }.shouldBeEmpty()
        robot(state, "r(2). +!start <- +begun.").use {
            it.shouldBelieve("resumed(_) & r(2) & begun").shouldNotBelieve("note(_)", 0.seconds)
        }
    }

    test("a person's order is kept at once") {
        val state = stateFile()
        robot(state, "limit(40).").use { robot ->
            robot.after(1.seconds).ordered(Order.Believe("-+limit(60)"))
            state.readText().lines() shouldContain "limit(60)[source(self)]."
        }
    }

    test("the state of an agent that runs on is five seconds old at most") {
        val state = stateFile()
        robot(state, "n(0). !count. +!count : n(N) <- .wait(100); -+n(N + 1); !count.").use { robot ->
            repeat(30) {
                robot.after(1.seconds)
                val n = Regex("""(?m)^n\((\d+)\)""").find(state.readText())!!.groupValues[1].toLong()
                withClue("at ${robot.now}") { n shouldBeGreaterThanOrEqual robot.now.inWholeMilliseconds / 100 - 50 }
            }
        }
    }
})
