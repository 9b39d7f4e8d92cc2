package argo.exploring

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import planted.PLANTED

/** Finds some of the planted faults. `./argo bench explore` looks for all of them. */
@Tags("Thorough")
class PlantedSpec : FunSpec({
    val folder = tempdir().toPath()

    mapOf(
        "unhandled" to "handles failures",
        "swallowed" to "loses no command",
        "retries" to "stays alive",
        "calibrates" to "never waits for ever",
        "typo" to "sends only known commands",
        "gives-up" to "acts again",
        "hangs-up" to "stops when blind",
        "equals" to "reacts to dist(front,D) & D < 20",
    ).forEach { (name, rule) ->
        test("the planted fault of $name breaks the rule that it $rule, and without the fault the same events break none") {
            val planted = PLANTED.single { it.name == name }
            val outcome = outcomeOf("${planted.write(folder, isMended = false)}") {
                planted.describe(this)
                runs = 60
            }
            val found = outcome.shouldBeInstanceOf<Found>()
            found.rule shouldBe rule
            found.events.size shouldBeLessThan 6
            shouldKeepRules("${planted.write(folder, isMended = true)}", *found.events.toTypedArray()) { planted.describe(this) }
        }
    }
})
