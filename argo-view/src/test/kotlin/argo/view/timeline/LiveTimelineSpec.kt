package argo.view.timeline

import argo.view.Chromium
import argo.view.ViewedMas
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse

@Tags("Thorough")
class LiveTimelineSpec : FunSpec({
    val browser: EnabledOrReasonIf = { Chromium.available }
    val chromium by autoClose(lazy { Chromium() })

    /** Runs [test] with an agent that has stopped in front of a wall. The agent is recorded if [record] is given. */
    suspend fun stopped(record: String?, percepts: String = "dist(front,38);", test: suspend (ViewedMas, FakeBoard) -> Unit) =
        FakeBoard.plugIn("robot").use { board ->
            board.lenient().whenAsked("getPercepts").answer(percepts)
            ViewedMas().use { mas ->
                mas.file("filters/near.xml", FILTER)
                mas.agent("bob", PROGRAM, options = listOfNotNull(record?.let { "argo_record" to it }).toMap())
                mas.awaitBelief("bob", "hold")
                test(mas, board)
            }
        }

    fun ViewedMas.get(path: String): HttpResponse<String> = HttpClient.newHttpClient()
        .send(HttpRequest.newBuilder(URI("${viewOf("bob")}$path")).build(), HttpResponse.BodyHandlers.ofString())

    test("why a command was sent, from the list of commands").config(enabledOrReasonIf = browser) {
        stopped("last(5)") { mas, _ ->
            chromium.show(mas.viewOf("bob")) {
                size(1280, 1000)
                await { "stop" in texts("#commands .text") }
                picture("live-why-button")
                follow("why")
                await { text("#item-title") == "stop" }
                text("#causes") shouldContain "argo.act(stop)"
                text("#causes") shouldContain "+dist(front,38)"
                text("#causes") shouldContain "percepts"
                texts("#causes small").last() shouldContain "line"
                await { run("return parts.length > 0 && !waiting") }
                await { texts("#sentences li").size > 3 }
                text("#sentences") shouldContain "agent bob sent stop to"
                text("#sentences") shouldContain "because of the step argo.act(stop), bob.asl:3"
                text("#sentences") shouldContain "its context: D < 50, which was 38 < 50"
                text("#sentences") shouldContain "let through: dist(front,38) is kept by filter near: it does not match rule 1"
                text("#sentences") shouldContain "whose last byte came at"
                text("#sentences") shouldContain "it would not have sent stop, but nothing"
                picture("live-timeline-light")
                prefer("prefers-color-scheme" to "dark")
                run<Any?>("draw(); return null")
                picture("live-timeline-dark")
                size(360, 740)
                await { run("return canvas.width === Math.round(canvas.clientWidth * devicePixelRatio)") }
                run<Long>("return document.documentElement.scrollWidth") shouldBeLessThanOrEqualTo 360
                picture("live-timeline-phone")
                follow("Live view")
                await { text("#agent") == "bob" }
                complaints().lines().filter { "SEVERE" in it } shouldBe emptyList()
            }
        }
    }

    test("the button now shows what has happened since").config(enabledOrReasonIf = browser) {
        stopped("last(5)") { mas, board ->
            chromium.show(mas.viewOf("bob").resolve("timeline")) {
                await { text("#name") == "bob" && run("return recording !== null && recording.number === 1") }
                board.whenAsked("getPercepts").answer("dist(front,39);")
                mas.awaitBelief("bob", "dist(front,39)")
                press("Now")
                await {
                    press("Now") // the cycle that perceives it may still be running
                    run("return JSON.stringify(parts).includes('dist(front,39)')")
                }
            }
        }
    }

    test("markup that a board sends is text").config(enabledOrReasonIf = browser) {
        stopped("last(5)", """say("<script>document.title='taken'</script><img src=x onerror=document.title='taken'>");""") { mas, _ ->
            chromium.show(mas.viewOf("bob").resolve("timeline")) {
                await { run("return parts.some(part => part.lane === 'PERCEPTS' && (part.items || []).length > 0)") }
                run<Any?>("choose(parts.find(part => part.lane === 'LINE').items[0].id); return null")
                await { "<img src=x" in text("#item-title") }
                run<Long>("return document.querySelectorAll('main img, main script').length") shouldBe 0
                run<String>("return document.title") shouldBe "bob – ARGO"
            }
        }
    }

    test("of an agent that is not recorded, the page has what to write").config(enabledOrReasonIf = browser) {
        stopped(null) { mas, _ ->
            chromium.show(mas.viewOf("bob").resolve("timeline")) {
                await { "argo_record=\"last(5)\"" in text("#problem") }
                size(360, 740)
                run<Long>("return document.documentElement.scrollWidth") shouldBeLessThanOrEqualTo 360
            }
        }
    }

    test("sentences that cannot be told") {
        stopped("last(5)") { mas, _ ->
            mas.get("why?agent=bob").statusCode() shouldBe 400
            mas.get("why?agent=bob&command=99").run {
                statusCode() shouldBe 404
                body() shouldContain "there is no command #99"
            }
        }
    }

    test("an agent that records to a file has its lanes, too, while the file is written") {
        val file = tempdir().toPath().resolve("drive.mcap")
        stopped("$file") { mas, _ ->
            mas.get("recording").body() shouldContain "\"agents\":[\"bob\"]"
            mas.get("item?command=1&of=1").body() shouldContain "argo.act(stop)"
        }
    }

    test("a page whose lanes are older than those of another is asked to take them anew") {
        stopped("last(5)") { mas, _ ->
            mas.get("items?from=0&until=1").statusCode() shouldBe 409
            mas.get("recording").body() shouldContain "\"number\":1"
            mas.get("items?from=0&until=1&of=1").statusCode() shouldBe 200
            mas.get("recording").body() shouldContain "\"number\":2"
            mas.get("items?from=0&until=1&of=1").run {
                statusCode() shouldBe 409
                body() shouldContain "press Now"
            }
            mas.get("item?command=99999&of=2").statusCode() shouldBe 404
            mas.get("items?from=5&until=1&of=2").statusCode() shouldBe 400
        }
    }
})

private val PROGRAM = """
    !start.
    +!start <- argo.port("sim:robot", [baud(1000000)]); argo.limit(500); argo.change_filter(near); argo.percepts(open).
    +dist(front,D) : D < 50 & not hold <- argo.act(stop); +hold.
    +say(_) <- argo.act(beep); +hold.
    +port(_,_).
""".trimIndent()

private val FILTER = """
    <PerceptionFilter>
      <filter><predicate>dist</predicate><parameter id="1" operator="GT">200</parameter></filter>
    </PerceptionFilter>
""".trimIndent()
