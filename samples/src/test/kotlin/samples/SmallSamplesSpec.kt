package samples

import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain

class SmallSamplesSpec : FunSpec({
    test("blink: the LED goes on and off") {
        Program.jason("blink").use { jason -> repeat(2) { listOf("LED on", "LED off").forEach(jason::awaitLine) } }
    }

    test("blink: the program ends when its time is over") {
        val (status, printed) = Program.run("blink", "--seconds", "2")
        printed shouldContain "LED on"
        status shouldBe 0
    }

    test("blink: a board that is not there ends it with the reason") {
        val (status, printed) = Program.run("blink", "--port", "sim:elsewhere")
        printed shouldContain "there is no simulated board sim:elsewhere"
        status shouldBe 1
    }

    fun ends(sample: String, vararg story: String) = context(sample) {
        mapOf("in plain Jason" to { Program.jason(sample) }, "by its command" to { Program.samples(sample) }).forEach { (how, start) ->
            test("$sample comes to its end $how").config(tags = thorough) {
                start().use { program ->
                    story.forEach { program.awaitLine(it) }
                    val (status, printed) = program.awaitEnd()
                    printed shouldNotContain "Exception"
                    status shouldBe 0
                }
            }
        }
    }

    ends(
        "two-boards", "[operator] the left LED is on", "[operator] the right LED is on", "[operator] the left LED is off",
        "[operator] the right LED is off",
    )

    ends(
        "three-boards", "[wheels] forward", "[wheels] halt", "[carrier] the can is ", "[arm] grip", "[carrier] the arm has the can",
        "[wheels] backward", "[wheels] halt", "[arm] release", "[carrier] the can is at the start",
    )

    ends(
        "typed-filters",
        "[watcher] through no filter: 4 distances, 4 lights",
        "[watcher] through frontOnly: 1 distances, 0 lights",
        "[watcher] dist(b,50) is dropped by filter frontOnly",
        "[watcher] through nearFront: 0 distances, 0 lights",
        "[watcher] dist(f,120) is dropped by filter nearFront",
    )

    ends("greenhouse", "[greenhouse] set(", "[operator] the storm is over") // on a busy machine, the vent opens behind the storm

    ends("sensing-agents", "[robot] drives", "[robot] stopped", "[pilot] the wall is")

    ends("delegation", "[robot] drives", "[pilot] the wall is", "[robot] stopped")
})

private val thorough = setOf(NamedTag("Thorough"))
