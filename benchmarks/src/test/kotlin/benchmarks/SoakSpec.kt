package benchmarks

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import kotlin.time.Duration.Companion.minutes

/** Runs `./argo bench soak` for nine seconds. */
@Tags("Thorough")
class SoakSpec : FunSpec({
    test("a hundred agents on a hundred boards leave no action unaccounted for, and neither heap nor threads grow")
        .config(timeout = 5.minutes, blockingTest = true) {
            Soak(agents = 100, seconds = 9).run().faults.shouldBeEmpty()
        }
})
