package experiment

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.doubles.shouldBeBetween
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.LineClock
import javino.sim.SimulatedBoards
import samples.board.FieldBoard
import samples.collision.Course
import samples.collision.Robot
import java.nio.file.Path
import kotlin.random.Random

/** Uses a robot that is known only by its port, like a real one. */
class RealLaboratorySpec : FunSpec({
    val host = AgentHost()
    val trial = Trial(Condition.DEFAULTS, View.FRONT_DISTANCE, 190, 20, 1)

    fun file(): Path = tempdir().toPath().resolve("record.jsonl")

    test("where it stopped is what its own sensor says") {
        val robot = Robot(LineClock.system(), Random(1))
        SimulatedBoards.plugIn("real", { FieldBoard(robot).run(it) })
        val file = file()
        val result = RecordWriter(file).use { RealLaboratory(host, "sim:real", { true }).run(trial, it, GivenUp()) }.shouldNotBeNull()
        result.outcome shouldBe Outcome.STOPPED
        result.distance.shouldBeBetween(150.0, 190.0, 0.0)
        result.sincePerceivingMs.shouldNotBeNull() shouldBeLessThanOrEqual result.sinceLimitMs
        robot.course.stateAt(LineClock.system().nanos()) shouldBe Course.State.STOPPED
        file.toFile().readLines().map { JSON.decodeFromString(Entry.serializer(), it) }.filterIsInstance<Entry.Belief>().shouldNotBeEmpty()
        SimulatedBoards.unplug("real")
    }

    test("a port that is not there ends the run with the reason") {
        val result = RecordWriter(file())
            .use { RealLaboratory(host, "sim:elsewhere", { true }).run(trial, it, GivenUp()) }.shouldNotBeNull()
        result.outcome shouldBe Outcome.FAILED
        result.reason shouldContain "there is no simulated board sim:elsewhere"
    }

    test("a run that is given up leaves the robot standing") {
        val robot = Robot(LineClock.system(), Random(1))
        SimulatedBoards.plugIn("abandoned", { FieldBoard(robot).run(it) })
        val given = GivenUp().apply { giveUp() }
        RecordWriter(file()).use { RealLaboratory(host, "sim:abandoned", { true }).run(trial, it, given) } shouldBe null
        (robot.course.stateAt(LineClock.system().nanos()) == Course.State.DRIVING) shouldBe false
        SimulatedBoards.unplug("abandoned")
    }

    test("a person is asked before each run, and an answer counts once") {
        val asked = ArrayList<String>()
        val given = GivenUp()
        val person = Attendant("\n\n".reader().buffered(), given) { asked += it }
        List(2) { person.ready(trial) } shouldBe listOf(true, true)
        asked.first() shouldContain "put the robot 200 cm from the wall for b-frontDistance-190-20-1"
        person.ready(trial) shouldBe false // no user answers any more
        given.isUp shouldBe true
    }

    test("nothing runs while the robot is not put back") {
        RecordWriter(file()).use { RealLaboratory(host, "sim:real", { false }).run(trial, it, GivenUp()) } shouldBe null
    }
})
