package argo.view

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import javino.sim.FakeBoard
import java.nio.file.Path
import java.util.Locale
import java.util.concurrent.TimeUnit
import kotlin.math.sin

private const val ROBOT = """
limit(20).
!start.

+!start
   <- argo.port("sim:robot"); argo.limit(100);
      argo.change_filter(ahead); argo.percepts(open);
      .print("driving");
      !drive.

+!drive : dist(f, Cm) & limit(L) & Cm < L
   <- argo.act(stop); .print("stopped at ", Cm, " cm").
+!drive
   <- argo.act(front); .wait(200); !drive.
"""
private const val SCOUT = """
!start.
+!start <- argo.ports([port("sim:left", [as(left)]), port("sim:right", [as(right)])]); argo.limit(50); argo.percepts(open).
"""
private const val AHEAD = """
    <PerceptionFilter><filter><predicate>dist</predicate><parameter id="0" operator="NE">f</parameter></filter></PerceptionFilter>
"""

/**
 * Tests the pages of a system of two agents in a real browser. With `-Dargo.write.pictures=true`, also makes the pictures of the
 * documentation, which takes a minute.
 */
@Tags("Thorough")
class SystemPageSpec : FunSpec({
    val browser: EnabledOrReasonIf = { Chromium.available }
    val chromium by autoClose(lazy { Chromium() })
    val pictures = Path.of("..", "docs", "pictures").takeIf { System.getProperty("argo.write.pictures") == "true" }

    /** Makes the picture [name] with colours of [scheme]. */
    fun Page.show(name: String, scheme: String) {
        prefer("prefers-color-scheme" to scheme, "prefers-reduced-motion" to "reduce")
        await { texts("#intentions .detail").any { it.startsWith("waits for") } }
        picture(name, pictures ?: Path.of("target", "view"))
    }

    /** Runs [test] with a robot that drives towards a wall, and a scout with two boards. */
    suspend fun system(test: suspend Page.(ViewedMas, List<FakeBoard>) -> Unit) {
        val boards = listOf("robot", "left", "right").map { FakeBoard.plugIn(it).lenient() }
        val begin = System.nanoTime()
        fun metres() = 2 - (System.nanoTime() - begin) / 1e9 / 40
        try {
            boards[0].version2().perceives("dist(f|b, cm 0..400)", "light(0..1023)", "temp(C -40..125)")
            boards[0].whenAsked("getPercepts").answer {
                val light = 140 + 60 * sin(metres() * 9)
                String.format(Locale.ROOT, "dist(f,%.0f);dist(b,%.0f);light(%.0f);temp(21.5);", metres() * 100, 200 - metres() * 100, light)
            }
            boards[1].whenAsked("getPercepts").answer("dist(30);")
            boards[2].whenAsked("getPercepts").answer("dist(40);")
            ViewedMas().use { mas ->
                mas.file("filters/ahead.xml", AHEAD)
                mas.agent("robot", ROBOT)
                mas.agent("scout", SCOUT)
                val view = mas.agentView("robot")
                view.show { Picture(track(metres() * 100), String.format(Locale.ROOT, "%.1f cm from the wall", metres() * 100)) }
                chromium.show(mas.viewOf("robot")) { test(mas, boards) }
            }
        } finally {
            boards.forEach(FakeBoard::close)
        }
    }

    test("intentions, printed lines and the courses of numbers are shown").config(enabledOrReasonIf = browser) {
        system { _, _ ->
            await { texts("#commands .text").any { it.startsWith("front ×") } }
            await { texts("#intentions .detail").any { it.startsWith("waits for .wait(200) · robot.asl:13") } }
            texts("#intentions .text").single() shouldBe "+!drive"
            texts("#intentions .detail").single() shouldContain "for +!start robot.asl:5"
            texts("#printed .text") shouldBe listOf("driving")
            await { run("return document.querySelectorAll('#sensors .course path').length === 4") }
            await { run("return document.querySelector('#sensors .course path').getAttribute('d').split('L').length > 3") }
            if (pictures != null) TimeUnit.SECONDS.sleep(50) // until the courses fill a minute
            size(1280, 1240)
            show("view-light", "light")
            show("view-dark", "dark")
            size(390, 844)
            run<Long>("return document.documentElement.scrollWidth") shouldBeLessThanOrEqualTo 390
            run<Any?>("document.getElementById('sensors-title').scrollIntoView(); return null")
            show("view-phone", "light")
            complaints().lines().filter { "SEVERE" in it } shouldBe emptyList()
        }
    }

    test("the agents of a system lead to each other, and one whose board is silent stands out").config(enabledOrReasonIf = browser) {
        system { _, boards ->
            await { texts("#agents a") == listOf("robot", "scout") }
            text("#agents [aria-current]") shouldBe "robot"
            boards[2].stall()
            await { texts("#agents a") == listOf("robot", "scout: board silent") }
            follow("scout: board silent")
            await { text("#agent") == "scout" && text("#agents [aria-current]").startsWith("scout") }
            await { texts("#sensors .text").toSet() == setOf("left::dist(30)", "right::dist(40)") }
            await { texts("#sensors li:not(.off) .text") == listOf("left::dist(30)") }
            text("#silence") shouldStartWith "The port \"sim:right\" does not answer"
            text("#silence").lines().size shouldBe 1
            boards[1].stall()
            val silent = setOf("The port \"sim:left\"", "The port \"sim:right\"")
            await { text("#silence").lines().map { it.substringBefore(" does") }.toSet() == silent }
            picture("two-silent")
            boards.drop(1).forEach(FakeBoard::resume)
            await { text("#silence").isEmpty() && texts("#agents a") == listOf("robot", "scout") }
        }
    }
})

/** Draws the robot, [cm] from the wall. */
private fun track(cm: Double): String {
    val x = (86 - cm / 200 * 86).coerceIn(0.0, 86.0)
    return """
        <svg xmlns="http://www.w3.org/2000/svg">
          <rect y="80" width="100%" height="3" fill="gray"/><rect x="96%" width="4%" height="83" fill="gray"/>
          <rect x="$x%" y="22" width="10%" height="46" rx="8" fill="teal"/>
          <circle cx="${x + 2}%" cy="68" r="12" fill="gray"/><circle cx="${x + 8}%" cy="68" r="12" fill="gray"/>
        </svg>
    """
}
