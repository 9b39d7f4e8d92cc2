package planted

import argo.exploring.Exploration
import argo.exploring.Rule
import argo.exploring.actsAgain
import argo.exploring.handlesFailures
import argo.exploring.losesNoCommand
import argo.exploring.neverActsOnStalePercepts
import argo.exploring.neverFloods
import argo.exploring.neverOscillates
import argo.exploring.neverSends
import argo.exploring.neverWaitsForever
import argo.exploring.perceivesAgain
import argo.exploring.reactsTo
import argo.exploring.sendsOnly
import argo.exploring.staysAlive
import argo.exploring.staysSmall
import argo.exploring.stopsWhenBlind
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

/**
 * A small agent with a beginner's fault, and the corrected agent. The file `planted/NAME.asl` contains both. Lines that end in `//-` belong
 * to the fault. The corrected agent has the lines that begin with `//+`, without this mark, and no line that ends in `//-`.
 *
 * @property rule the name of the rule that the fault breaks
 * @property describe describes the board and the rules, which are equal for both agents
 */
class Planted(val name: String, val rule: String, val describe: Exploration.() -> Unit) {
    fun write(folder: Path, isMended: Boolean): Path {
        val lines = checkNotNull(javaClass.getResource("/planted/$name.asl")) { "there is no $name.asl" }.readText().lines()
        val text = lines.filterNot { isMended && it.endsWith("//-") }.map { if (isMended) it.removePrefix("//+ ") else it }
        return folder.createDirectories().resolve("${name.replace('-', '_')}.asl").apply { writeText(text.joinToString("\n")) }
    }

    override fun toString() = name
}

val PLANTED: List<Planted> = listOf(
    Planted("ages", "stops when blind") { driver() },
    Planted("silence", "stops when blind") { driver() },
    Planted("unhandled", "handles failures") { driver() },
    Planted("swallowed", "loses no command") { lamp() },
    Planted("retries", "stays alive") { driver() },
    Planted("calibrates", "never waits for ever") { arm() },
    Planted("logs", "stays small") { driver() },
    Planted("remembers", "stays small") { driver() },
    Planted("threshold", "never oscillates") { driver() },
    Planted("typo", "sends only known commands") { driver() },
    Planted("gives-up", "acts again") { driver(actsAgain()) },
    Planted("blocks", "perceives again") { driver() },
    Planted("hangs-up", "perceives again") { driver() },
    Planted("quits", "stays alive") { driver() },
    Planted("atomic", "reacts to $NEAR") { driver() },
    Planted("once", "stops when blind") { driver() },
    Planted("equals", "reacts to $NEAR") { driver() },
    Planted("drops", "acts again") { driver(actsAgain()) },
    Planted("loops", "never floods") { orders() },
    Planted("reopens", "handles failures") { driver() },
    Planted("one-error", "handles failures") { driver(isVersion2 = true) },
    Planted("decides-early", "never sends front while $NEAR") { driver() },
    Planted("next-change", "never waits for ever") { driver() },
    Planted("follows", "never floods") { bar() },
    Planted("lost-line", "stays alive") { line() },
)

private const val NEAR = "dist(front,D) & D < 20"

private val MOVING = listOf("front", "left", "steer")

/** Describes a robot that drives towards objects and stops in front of them. */
private fun Exploration.driver(vararg more: Rule, isVersion2: Boolean = false) {
    board("ttyACM0") {
        if (isVersion2) version2()
        sensor("dist(front,%d)", 5..200)
    }
    rules(
        any() + listOf(
            neverActsOnStalePercepts(except = listOf("stop")), stopsWhenBlind("stop", MOVING), reactsTo(NEAR, listOf("stop")),
            neverSends(listOf("front"), NEAR), sendsOnly(listOf("front", "left", "right", "back", "stop")),
        ) + more,
    )
}

private fun any() = listOf(
    staysAlive(), handlesFailures(), losesNoCommand(), neverWaitsForever(), staysSmall(intentions = 10, beliefs = 30), neverFloods(10),
    neverOscillates(), perceivesAgain(),
)

private fun Exploration.lamp() {
    board("ttyACM0") { sensor("light(%d)", 0..9) }
    message("swallowed", "boss", "achieve", "lamp(ledOn)")
    message("swallowed", "boss", "achieve", "lamp(ledOff)")
    rules(any() + sendsOnly(listOf("ledOn", "ledOff")))
}

private fun Exploration.arm() {
    board("ttyACM0") { sensor("place(home)", "place(lost)", "place(shelf)") }
    rules(any() + sendsOnly(listOf("home")))
}

private fun Exploration.orders() {
    board("ttyACM0") { sensor("light(%d)", 0..9) }
    message("loops", "boss", "achieve", "blink(ledOn)")
    message("loops", "boss", "achieve", "blink(ledOff)")
    rules(any() + sendsOnly(listOf("ledOn", "ledOff")))
}

private fun Exploration.bar() {
    board("ttyACM0") { sensor("dist(front,%d)", 5..200) }
    rules(any() + sendsOnly(listOf("bar/1")))
}

private fun Exploration.line() {
    board("ttyACM0") { sensor("line(left)", "line(right)", "") }
    rules(any() + listOf(stopsWhenBlind("stop", MOVING), sendsOnly(listOf("steer/1", "stop"))))
}
