package benchmarks

import benchmarks.ros.ros
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.time.Duration.Companion.minutes

/** Runs `./argo bench ros` for two seconds at one rate, without roslibpy. */
@Tags("Thorough")
class RosSpec : FunSpec({
    test("an agent behind a bridge that is restarted ten times acts on, once for each command, and leaves nothing behind")
        .config(timeout = 5.minutes, blockingTest = true) {
            ros(python = null, seconds = 2, rates = listOf(200)) shouldBe true
        }
})
