package javino.link

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.maps.shouldBeEmpty
import io.kotest.matchers.shouldBe
import javino.virtual.Bounded
import javino.virtual.checkBounds

/** Checks the bounds of docs/real-time.md. `./argo bench bounds` makes a million exchanges. */
@Tags("Thorough")
class BoundsSpec : FunSpec({
    test("no exchange takes longer than its bound, whatever the line, the board and the agent's interval") {
        val closest = checkBounds(exchanges = 20_000, seed = 1)
        closest.keys shouldBe Bounded.entries.toSet()
        closest.filterValues { it.share > 1 }.mapValues { (_, found) -> "$found" }.shouldBeEmpty()
    }
})
