package samples.greenhouse

import javino.LineClock
import kotlin.random.Random

private const val NANOS_A_MINUTE = 10_000_000.0

/** `sim:greenhouse`, the board of the sample `greenhouse`. The board logs its commands. A minute in the greenhouse takes 10 ms. */
class GreenhouseBoard : Greenhouse(Random(2016), lapsed(LineClock.system())) {
    override fun act(command: String): Boolean {
        System.getLogger("samples.greenhouse").log(System.Logger.Level.INFO, command)
        return super.act(command)
    }
}

/** Returns a function that gives the minutes in the greenhouse since its first call. */
private fun lapsed(clock: LineClock): () -> Double {
    val begin by lazy { clock.nanos() }
    return { (clock.nanos() - begin) / NANOS_A_MINUTE }
}
