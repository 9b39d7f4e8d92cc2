package argo.view.timeline

import argo.recording.replay.Recording
import argo.testkit.mas
import argo.view.Chromium
import argo.view.Page
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import io.kotest.matchers.string.shouldContain
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.nio.file.Path
import kotlin.io.path.readBytes
import kotlin.io.path.writeBytes
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/**
 * Tests the page of a recording of two agents in a real browser. With `-Dargo.write.pictures=true`, also makes the picture of the
 * documentation.
 */
@Tags("Thorough")
class TimelinePageSpec : FunSpec({
    val browser: EnabledOrReasonIf = { Chromium.available }
    val chromium by autoClose(lazy { Chromium() })
    val pictures = Path.of("..", "docs", "pictures").takeIf { System.getProperty("argo.write.pictures") == "true" }
    val folder = tempdir().toPath()
    val file = folder.resolve("drive.mcap")

    mas {
        agentOf("robot", ROBOT) { options("argo_record" to "$file") }
        agentOf("lamp", LAMP) { options("argo_record" to "$file") }
    }.use { mas ->
        var cm = 90
        repeat(30) {
            mas["robot"].perceives("dist(front,$cm)", "light(${140 + cm % 7})")
            mas["lamp"].perceives("dark(${cm % 4})")
            mas["robot"].after(200.milliseconds)
            cm -= 2
        }
        mas["robot"].after(1.seconds)
    }

    val timeline = Recording(file).use(Timeline::of)
    val server = autoClose(TimelineServer(timeline, listOf(file), emptyList(), 0))

    fun get(path: String, host: String? = null): HttpResponse<String> {
        val request = HttpRequest.newBuilder(URI("${server.address}$path"))
        if (host != null) request.header("Origin", host)
        return HttpClient.newHttpClient().send(request.build(), HttpResponse.BodyHandlers.ofString())
    }

    /** Clicks the first item of [lane] whose text is [text]. */
    fun Page.click(lane: Lane, text: String) {
        val item = timeline.items.first { it.lane == lane && it.text == text }
        await { run("return parts.length > 0") }
        run<Any?>("choose(arguments[0]); return null", item.id)
        await { text("#item-title") == text }
    }

    test("lanes of both agents, and what lights up with a command").config(enabledOrReasonIf = browser) {
        chromium.show(server.address) {
            size(1280, 1120)
            prefer("prefers-color-scheme" to "light")
            await { text("#range").endsWith("s") && run("return parts.some(part => (part.items || []).length > 0)") }
            text("#name") shouldBe "drive.mcap"
            click(Lane.COMMANDS, "stop")
            text("#causes") shouldContain "argo.act(stop)"
            texts("#causes small").last() shouldContain "line"
            text("#detail") shouldContain "to ttyACM0"
            val stop = timeline.items.first { it.lane == Lane.COMMANDS && it.text == "stop" }
            run<Any?>("see(arguments[0], arguments[1]); return null", stop.from - 0.5, stop.from + 0.5)
            await { run("return parts.length > 0 && !waiting") }
            picture("timeline-light", pictures ?: Path.of("target", "view"))
            prefer("prefers-color-scheme" to "dark")
            run<Any?>("draw(); return null")
            picture("timeline-dark")
            size(390, 844)
            await { run("return canvas.width === Math.round(canvas.clientWidth * devicePixelRatio)") }
            run<Long>("return document.documentElement.scrollWidth") shouldBeLessThanOrEqualTo 390
            picture("timeline-phone")
            complaints().lines().filter { "SEVERE" in it } shouldBe emptyList()
        }
    }

    test("a click, keys and buttons do what they are for").config(enabledOrReasonIf = browser) {
        chromium.show(server.address) {
            await { run("return parts.some(part => (part.items || []).length > 0)") }
            val all = text("#range")
            run<Any?>("canvas.focus(); return null")
            type("+")
            await { text("#range") != all }
            type("0")
            await { text("#range") == all }
            press("After") // chooses the first item
            await { text("#item-title") != "Select an item" }
            val first = run<Long>("return chosen.item.id")
            type(".")
            await { run<Long>("return chosen.item.id") != first }
            type(",")
            await { run<Long>("return chosen.item.id") == first }
            run<Any?>(
                """
                const part = parts.find(one => one.lane === 'COMMANDS' && one.items);
                const box = canvas.getBoundingClientRect();
                const at = { pointerId: 1, bubbles: true, clientX: box.left + x(part.items[0].from) + 1,
                  clientY: box.top + laneTop(part.agent, part.lane) + 28 };
                canvas.setPointerCapture = () => {};
                canvas.dispatchEvent(new PointerEvent('pointerdown', at));
                canvas.dispatchEvent(new PointerEvent('pointerup', at));
                return null;
                """.trimIndent(),
            )
            await { text("#detail").contains("commands") }
            run<Any?>("document.querySelector('#causes button').click(); return null")
            await { text("#detail").contains("intentions") }
        }
    }

    test("requests that make no sense, and those of other pages, are refused in words") {
        get("items?from=5&until=1").run {
            statusCode() shouldBe 400
            body() shouldContain "from and until are seconds"
        }
        get("item?id=99999999").statusCode() shouldBe 404
        get("etc/passwd").statusCode() shouldBe 404
        get("recording", "http://elsewhere.example").statusCode() shouldBe 403
        get("item?id=0").statusCode() shouldBe 200
    }

    test("of a recording that was cut off, what is whole is shown") {
        val cut = folder.resolve("cut.mcap").apply { writeBytes(file.readBytes().let { it.copyOf(it.size * 2 / 3) }) }
        Recording(cut).use {
            val shown = Timeline.of(it)
            it.problems shouldNotBe emptyList<String>()
            shown.agents shouldBe timeline.agents
        }
    }
})

private val ROBOT = """
    !start.
    +!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.

    +!drive : stopped.
    +!drive
       <- argo.act(front); .wait(250); !drive.

    +dist(front,D) : D < 50 & not stopped
       <- +stopped; argo.act(stop);
          .print("stopped at ", D, " cm").
    +port(_,_).
""".trimIndent()

private val LAMP = """
    !start.
    +!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open).
    +dark(N) : N > 1 <- argo.act(lampOn).
    +dark(_) <- argo.act(lampOff).
    +port(_,_).
""".trimIndent()
