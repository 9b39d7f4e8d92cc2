package samples.lamp

import argo.testkit.agent
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import kotlin.io.path.Path
import kotlin.time.Duration.Companion.minutes

@Tags("Thorough")
class BlinkSpec : FunSpec({
    test("the LED goes on and off twice a second, for ten minutes, and for good") {
        agent(Path("blink/blink.asl")) { options("beliefs" to "board(ttyACM0)") }.use { blink ->
            blink.after(10.minutes)
            check(blink.sent.size in 1_160..1_200) { "${blink.sent.size} commands" } // each command also takes line time
            blink.sent.withIndex().all { (i, command) -> command == if (i % 2 == 0) "ledOn" else "ledOff" } shouldBe true
        }
    }
})
