package samples.collision

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll
import javino.Frame
import kotlin.math.ceil
import kotlin.random.Random

private val percept = Regex("""(dist|light|temp)\(([fbrl]),(\d+)\)""")

private fun readings(frame: List<String>): Map<String, Int> =
    frame.mapNotNull(percept::matchEntire).associate { it.groupValues[1] + it.groupValues[2] to it.groupValues[3].toInt() }

class SensorsSpec : FunSpec({
    test("a frame is the twelve percepts of the experiment") {
        val frame = Sensors(Random(1)).frame(123.0)
        frame.size shouldBe 12
        readings(frame).keys shouldBe listOf("dist", "light", "temp").flatMap { kind -> "fbrl".map { "$kind$it" } }.toSet()
    }

    test("every percept changes from frame to frame, whether the robot moves or not") {
        checkAll(Arb.int(), Arb.numericDouble(0.0, 200.0), Arb.numericDouble(0.0, 3.0)) { seed, distance, step ->
            val sensors = Sensors(Random(seed))
            val first = readings(sensors.frame(distance))
            val second = readings(sensors.frame((distance - step).coerceAtLeast(0.0)))
            first.keys.forEach { second.getValue(it) shouldNotBe first.getValue(it) }
        }
    }

    test("the front distance never reads short, and at most its noise too long") {
        checkAll(Arb.int(), Arb.numericDouble(0.0, 200.0)) { seed, distance ->
            val reading = readings(Sensors(Random(seed)).frame(distance)).getValue("distf")
            distance shouldBeLessThanOrEqual reading.toDouble()
            reading shouldBeLessThanOrEqual ceil(distance).toInt() + Sensors.DISTANCE_NOISE
        }
    }

    test("a frame fits into one message wherever the robot is") {
        checkAll(Arb.numericDouble(0.0, 200.0)) {
            Sensors(Random(1)).frame(it).sumOf { percept -> percept.length + 1 } shouldBeLessThanOrEqual Frame.MAX_PAYLOAD
        }
    }

    test("the same seed gives the same frames") {
        val one = Sensors(Random(7))
        val other = Sensors(Random(7))
        repeat(20) { one.frame(100.0) shouldBe other.frame(100.0) }
    }
})
