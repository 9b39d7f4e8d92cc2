package benchmarks.stops

import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

/** Runs `./argo bench stops` with fewer stops. The figures are equal on every machine, so they have limits. */
class StopsSpec : FunSpec({
    val built: EnabledOrReasonIf = {
        if (Bench.isBuilt(LIMITS.keys)) Enabled.enabled else Enabled.disabled("there are no robots: ./argo firmware says what they need")
    }
    val measured = LIMITS.keys.associateWith { lazy { measureStops(it, STOPS, SEED) } }

    LIMITS.forEach { (course, limit) ->
        test("the published agent stops the robot within $limit ms and no command is lost: $course").config(enabledOrReasonIf = built) {
            val stops = measured.getValue(course).value
            stops.distribution.ms(1.0) shouldBeLessThan limit
            stops.starts shouldBe 1
            if (course.version == 1) stops.commands shouldBe stops.sent
        }
    }

    test("a run gives the same figures again, and others from another seed").config(tags = thorough, enabledOrReasonIf = built) {
        measureStops(FAST, STOPS, SEED).responses shouldBe measured.getValue(FAST).value.responses
        measureStops(FAST, 1, SEED + 1).responses.first() shouldNotBe measured.getValue(FAST).value.responses.first()
    }
})

private const val STOPS = 5
private const val SEED = 1L
private val FAST = StopCourse(115_200)

/** The upper bounds for the longest stop of each course in ms. The bounds are up to a third above the measured values. */
private val LIMITS = mapOf(
    StopCourse(9_600) to 150.0,
    FAST to 40.0,
    StopCourse(9_600, version = 1) to 750.0,
    StopCourse(9_600, version = 1, Firmware.FIELD, loopMs = 5) to 1_200.0,
)

internal val thorough = setOf(NamedTag("Thorough"))
