package argo.view

import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldNotContain
import io.kotest.matchers.string.shouldStartWith
import javino.sim.FakeBoard
import org.openqa.selenium.Keys

private const val AGENT = """
    likes(tea).
    !start.
    +!start <- argo.port("sim:robot", [baud(1000000)]); argo.limit(20); argo.change_filter(front); argo.percepts(open);
        argo.act(hello); !long.
    +!rest <- .wait(600000).
    +!long <- argo.act("a command that is too long for a narrow page unless words could be broken_anywhere_in_the_middle_of_them").
"""

/** A picture that would change the page's title if its script ran. */
private const val SVG = """
    <svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">
      <rect width="9" height="9" fill="teal"/><script>parent.document.title='taken'</script>
    </svg>
"""
private const val FRONT = """
    <PerceptionFilter>
      <filter><predicate>dist</predicate><parameter id="0" operator="NE">f</parameter></filter>
    </PerceptionFilter>
"""

class PageSpec : FunSpec({
    val browser: EnabledOrReasonIf = { Chromium.available }
    val chromium by autoClose(lazy { Chromium() })

    suspend fun shown(
        answer: String, kinds: List<String> = emptyList(), test: suspend Page.(ViewedMas, FakeBoard) -> Unit,
    ) = FakeBoard.plugIn("robot").use { board ->
        board.lenient().whenAsked("getPercepts").answer(answer)
        if (kinds.isNotEmpty()) board.version2().perceives(*kinds.toTypedArray())
        ViewedMas().use { mas ->
            mas.file("front.xml", FRONT)
            mas.agent("bob", AGENT)
            chromium.show(mas.viewOf("bob")) {
                await {
                    texts("#sensors .text").isNotEmpty() && texts("#beliefs .text").size > 2 && texts("#commands .text").size == 2
                }
                mas.agentView("bob").show { Picture(SVG, "73.2 cm – driving") }
                await { run("return !document.getElementById('picture').hidden") }
                test(mas, board)
            }
        }
    }

    test("the page shows the agent").config(enabledOrReasonIf = browser) {
        shown("dist(f,38);dist(b,90);light(4);temp(20);") { _, _ ->
            text("#connection") shouldBe "live"
            text("#agent") shouldBe "bob"
            texts("#sensors .text") shouldBe listOf("dist(f,38)", "dist(b,90)", "light(4)", "temp(20)")
            texts("#sensors .chip") shouldBe listOf("kept", "dropped", "kept", "kept")
            texts("#beliefs .text").toSet() shouldBe setOf("likes(tea)", "port(\"sim:robot\",on)", "dist(f,38)", "light(4)", "temp(20)")
            texts("#commands .chip").forEach { it shouldContain "done in" }
            texts("#ports .chip") shouldBe listOf("on")
            text("#picture figcaption") shouldBe "73.2 cm – driving"
            await { run("return document.querySelector('#picture img').naturalWidth > 0") }
            run<String>("return document.title") shouldBe "bob · ARGO"
            await { "/s" in text("#figures") }
            picture("light")
            prefer("prefers-color-scheme" to "dark")
            picture("dark")
        }
    }

    test("of critical rules, courses and agents that are too many to be shown the page tells the number")
        .config(tags = thorough, enabledOrReasonIf = browser) {
            FakeBoard.plugIn("robot").use { board ->
                board.lenient().version2().whenAsked("getPercepts").answer((1..70).joinToString("") { "s$it($it);" })
                ViewedMas().use { mas ->
                    val rules = (1..60).joinToString("") { "<critical><predicate>near$it</predicate></critical>" }
                    mas.file("front.xml", "<PerceptionFilter>$rules</PerceptionFilter>")
                    mas.agent("bob", AGENT)
                    chromium.show(mas.viewOf("bob")) {
                        await { texts("#critical li").size == 50 && texts(".course svg").size == 60 }
                        text("#critical-words") shouldBe "10 more critical rules are not shown."
                        text("#sensors-words") shouldEndWith "The courses of 10 more sensors are not shown."
                        run<Any?>(
                            """
                            state.agents = [...Array(200).keys()].map(i => ({ name: i ? `scout${'$'}{i}` : 'bob' }));
                            state.moreAgents = 5;
                            document.getElementById('freeze').click();
                            """,
                        )
                        await { texts("#agents span") == listOf("… 5 more, each at its own /NAME/") }
                        size(1280, 2600)
                        run<Any?>("document.getElementById('agents').scrollTop = 9999")
                        picture("more")
                    }
                }
            }
        }

    test("the computers of a fleet are shown with their agents, and links to the views of this machine").config(
        tags = thorough, enabledOrReasonIf = browser,
    ) {
        ViewedMas().use { mas ->
            mas.agent("bob", "likes(tea).")
            chromium.show(mas.viewOf("bob")) {
                await { text("#agent") == "bob" }
                run<Any?>(
                    """
                    state.computers = [
                      { name: 'base', address: '127.0.0.1', here: true, near: true, on: true, more: 3,
                        agents: [{ name: 'bob', viewPort: 8080 }, { name: 'eve', viewPort: null }] },
                      { name: 'scout1', address: '127.0.0.1', here: false, near: true, on: true, more: 0,
                        agents: [{ name: 'ann', viewPort: 8081 }] },
                      { name: 'scout2', address: '10.8.0.12', here: false, near: false, on: true, more: 0,
                        agents: [{ name: 'joe', viewPort: 8080 }] },
                      { name: 'scout3', address: '10.8.0.13', here: false, near: false, on: false, agents: [], more: 0 },
                    ];
                    document.getElementById('freeze').click();
                    """,
                )
                await { texts("#computers .chip") == listOf("on", "on", "on", "off") }
                texts("#computers .text") shouldBe listOf("base, this one", "scout1", "scout2", "scout3")
                texts("#computers .detail") shouldBe listOf("bob, eve, 3 more", "ann", "joe", "")
                run<List<String>>("return [...document.querySelectorAll('#computers a')].map(it => it.port + it.pathname)") shouldBe
                    listOf("8080/bob/", "8081/ann/")
                run<String>("return [...document.querySelectorAll('#computers span')].find(it => it.title).title") shouldBe
                    "Its live view is at port 8080 of 10.8.0.12: ssh -L 8080:127.0.0.1:8080 10.8.0.12"
            }
        }
    }

    test("units and ranges that the board describes are shown, and a percept that is not as described is marked").config(
        tags = thorough, enabledOrReasonIf = browser,
    ) {
        val kinds = listOf("dist(f|b, cm 0..400)", "light(% 0..100)", "temp(C -40..)")
        shown("dist(f,38);light(104);temp(20);on(1);", kinds) { _, board ->
            await { texts("#sensors .text") == listOf("dist(f,38 cm)", "light(104 %)", "temp(20 C)", "on(1)") }
            texts("#sensors .detail") shouldBe listOf(
                "", "not as the board describes it: argument 1 is 104, more than 100",
                "", "not as the board describes it: no on/1 is described",
            )
            texts("#sensors .odd .text") shouldBe listOf("light(104 %)", "on(1)")
            await { texts("#sensors .course small") == listOf("0 … 400 cm", "0 … 100 %", "-40 … C") }
            run<Long>("return document.querySelectorAll('#sensors .limit').length") shouldBe 5
            run<Long>("return document.querySelectorAll('#sensors .beyond').length") shouldBe 1
            board.whenAsked("getPercepts").answer("dist(f,39);light(90);temp(21);on(1);")
            await { texts("#sensors .odd .text") == listOf("on(1)") }
            press("dist(f,39 cm)")
            await { texts("#sensors .detail")[0].startsWith("dist(f,39) is kept") }
            picture("described-light")
            prefer("prefers-color-scheme" to "dark")
            picture("described-dark")
            size(360, 2400)
            run<Long>("return document.documentElement.scrollWidth") shouldBeLessThanOrEqualTo 360
            picture("described-phone")
        }
    }

    test("on a phone nothing has to be scrolled sideways").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);" + "x".repeat(180) + "(1);dist(b,90);") { _, _ ->
            size(360, 740)
            run<Long>("return document.documentElement.scrollWidth") shouldBeLessThanOrEqualTo 360
            picture("phone")
            size(360, 3400)
            picture("phone-long")
            size(320, 640)
            run<Long>("return document.documentElement.scrollWidth") shouldBeLessThanOrEqualTo 320
        }
    }

    test("markup that a board says is text").config(tags = thorough, enabledOrReasonIf = browser) {
        val percepts = """say("<img src=x onerror=document.title='taken'><b>x</b>");'</li><script>document.title=\'taken\'</script>'(1);"""
        shown(percepts) { _, _ ->
            texts("#sensors .text") shouldContainText "<img src=x"
            texts("#beliefs .text") shouldContainText "<b>x</b>"
            run<Long>("return document.querySelectorAll('section img, section b, main script').length") shouldBe 0
            run<String>("return document.title") shouldBe "bob · ARGO"
        }
    }

    test("a press on a percept tells why, and another takes it away").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);dist(b,90);") { _, _ ->
            press("dist(b,90)")
            await { texts("#sensors .detail")[1].contains("is dropped by filter front: it matches rule 1") }
            picture("why")
            press("dist(b,90)")
            await { texts("#sensors .detail").all { it.isEmpty() } }
        }
    }

    test("why a percept is kept or dropped is renewed when it or the filter changes").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);dist(b,90);") { _, board ->
            press("dist(b,90)")
            await { texts("#sensors .detail")[1].startsWith("dist(b,90) is dropped by filter front") }
            board.whenAsked("getPercepts").answer("dist(f,38);dist(b,91);")
            await { texts("#sensors .detail")[1].startsWith("dist(b,91) is dropped by filter front") }
            press("none")
            await { texts("#sensors .detail")[1].startsWith("dist(b,91) is kept: there is no filter") }
        }
    }

    test("a board that is silent is announced, and its sensors show the past").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);dist(b,90);") { _, board ->
            text("#silence") shouldBe ""
            board.stall()
            await { text("#silence").startsWith("The port \"sim:robot\" does not answer") }
            text("#connection") shouldBe "board silent"
            texts("#sensors .chip.good") shouldBe emptyList()
            text("#sensors-count") shouldBe "1 of 2 reached the agent"
            picture("silent")
            board.resume()
            await { text("#silence").isEmpty() && text("#connection") == "live" && texts("#sensors .chip.good") == listOf("kept") }
            board.close()
            await { text("#silence").startsWith("The port \"sim:robot\" is off: ") }
            picture("off")
        }
    }

    test("buttons change the agent's filter").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);dist(b,90);") { mas, _ ->
            await { texts("#filters [aria-pressed=true]") == listOf("front") }
            press("none")
            await { texts("#filters [aria-pressed=true]") == listOf("none") && texts("#sensors .chip") == listOf("kept", "kept") }
            mas.awaitBelief("bob", "dist(b,90)")
            mas.file("front.xml", "<PerceptionFilter><filter/></PerceptionFilter>")
            press("front")
            await { text("#problem").contains("predicate") }
            text("#problem").lines().first() shouldEndWith "front.xml is refused:"
            text("#problem").lines()[1] shouldStartWith "line 1, column 19: "
            texts("#filters [aria-pressed=true]") shouldBe listOf("none")
            picture("refused")
            press("Dismiss")
            run<Boolean>("return document.getElementById('trouble').hidden") shouldBe true
        }
    }

    test("beliefs are searched for words in their text and source").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);dist(b,90);light(4);") { _, board ->
            text("#beliefs-count") shouldBe "4"
            enter("#find", "percept F,")
            await { texts("#beliefs .text") == listOf("dist(f,38)") && text("#beliefs-count") == "1 of 4" }
            picture("found")
            board.whenAsked("getPercepts").answer("dist(f,37);dist(b,90);light(4);")
            await { texts("#beliefs .text") == listOf("dist(f,37)") }
            enter("#find", "nothing of this")
            await { texts("#beliefs li") == listOf("No belief has these words.") }
            enter("#find", " ")
            await { texts("#beliefs .text").size == 4 && text("#beliefs-count") == "4" }
        }
    }

    test("percepts are blocked and opened by a button, also from the keyboard").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);") { _, _ ->
            run<Any?>("document.getElementById('percepts').focus(); return null")
            type(Keys.ENTER)
            await { text("#percepts") == "Open percepts" && text("#sensors-words").contains("blocked") }
            await { run("return !document.getElementById('percepts').disabled") }
            press("Open percepts")
            await { text("#percepts") == "Block percepts" }
        }
    }

    test("a frozen page stands still while the agent goes on").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);dist(b,90);") { mas, _ ->
            press("Freeze page")
            text("#notice") shouldContain "The agent goes on"
            val figures = text("#figures")
            mas.achieve("bob", "start")
            mas.achieve("bob", "long")
            mas.awaitBelief("bob", "dist(f,38)")
            text("#figures") shouldBe figures
            press("Unfreeze page")
            await { texts("#commands .text").size > 2 && text("#notice").isEmpty() }
        }
    }

    test("keyboard focus stays where it is while the page changes").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);dist(b,90);") { _, _ ->
            run<Any?>("document.querySelectorAll('#sensors button')[1].focus(); return null")
            press("none") // changes every row
            run<Any?>("document.querySelectorAll('#sensors button')[1].focus(); return null")
            await { texts("#sensors .chip") == listOf("kept", "kept") }
            run<String>("return document.activeElement.textContent") shouldBe "dist(b,90)"
        }
    }

    test("the agent's end is told, and what was seen last stays").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);") { mas, _ ->
            mas.agentView("bob").show { Picture(SVG, "stopped 38.6 cm from the wall") }
            mas.kill("bob")
            await { text("#connection") == "ended" }
            text("#notice") shouldContain "The agent has ended"
            text("#picture figcaption") shouldBe "stopped 38.6 cm from the wall"
            texts("#sensors .text") shouldBe listOf("dist(f,38)")
            run<Long>("return [...document.querySelectorAll('header button, #filters button')].filter(b => !b.disabled).length") shouldBe 0
            picture("ended")
        }
    }

    test("a command is sent by hand, and equal ones are counted").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);") { _, board ->
            repeat(3) { round ->
                enter("#command", "stop")
                type(Keys.ENTER)
                await { text("#sent") == "stop: done" && board.received().count { it == "stop" } == round + 1 }
            }
            await { texts("#commands .text").first() == "stop ×3" }
            enter("#command", "speed(")
            press("Send")
            await { text("#sent").startsWith("speed(: wrong_arguments: 'speed(' is not a literal that Jason can read") }
            board.received().count { "speed" in it } shouldBe 0
        }
    }

    test("beliefs and goals are set by hand, and the program is reloaded").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);") { mas, _ ->
            enter("#belief", "-+likes(milk)")
            press("Believe")
            await { "likes(milk)" in texts("#beliefs .text") && "likes(tea)" !in texts("#beliefs .text") }
            texts("#beliefs .act:not([hidden])").size shouldBe 1 // percepts have no button
            enter("#belief", "likes(")
            type(Keys.ENTER)
            await { texts(".answer.failed").any { "likes(" in it } }
            pressOn("[aria-label='forget likes(milk)']")
            await { "likes(milk)" !in texts("#beliefs .text") }
            enter("#goal", "rest")
            press("Begin")
            await { texts("#intentions .text") == listOf("+!rest") }
            picture("hand-light")
            pressOn("#intentions .act")
            await { texts("#intentions .empty").size == 1 }
            mas.file("bob.asl", AGENT.replace("+!rest <- .wait", "+!rest <- .print(resting); .wait"))
            press("Reload")
            await { text("#problem").startsWith("1 plan changed") }
            picture("reloaded")
            press("Dismiss")
            enter("#goal", "rest")
            press("Begin")
            await { texts("#printed .text") == listOf("resting") }
            mas.file("bob.asl", AGENT + "+!broken <- .")
            press("Reload")
            await { "bob.asl" in text("#problem") && run("return document.getElementById('trouble').matches('.problem')") }
            picture("not-reloaded")
        }
    }

    test("the agent is paused, goes on for a cycle, and stops at a line").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);") { mas, _ ->
            enter("#place", "bob.asl:${AGENT.lines().indexOfFirst { "+!rest" in it } + 1}")
            press("Stop there")
            await { texts("#breakpoints .text").size == 1 }
            enter("#goal", "rest")
            press("Begin")
            await { text("#connection") == "paused" && texts("#intentions .chip") == listOf("paused here") }
            picture("stands")
            enter("#belief", "noted(standing)")
            press("Believe")
            await { "noted(standing)" in texts("#beliefs .text") }
            press("One cycle")
            await { text("#connection") == "paused" }
            press("remove")
            await { texts("#breakpoints .text").isEmpty() }
            press("Go on")
            await { text("#connection") == "live" && texts("#intentions .detail").single().startsWith("waits for .wait") }
            press("Pause")
            await { text("#connection") == "paused" }
            mas.awaitBelief("bob", "noted(standing)")
        }
    }

    test("another page in the browser can order nothing").config(tags = thorough, enabledOrReasonIf = browser) {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient().whenAsked("getPercepts").answer("dist(f,38);")
            ViewedMas().use { mas ->
                mas.file("front.xml", FRONT)
                mas.agent("bob", AGENT)
                board.awaitMessage("hello", 20_000)
                mas.file("bob.asl", "") // a reload would remove all plans
                val view = mas.viewOf("bob")
                OtherSite("$ATTACK('$view')").use { other ->
                    chromium.show(other.address) {
                        await { run("return document.title === 'all tried'") }
                    }
                }
                view.post("begin", """{"text":"rest"}""").statusCode() shouldBe 200
                view.post("believe", """{"text":"last"}""").statusCode() shouldBe 200
                view.post("command", """{"command":"last"}""").statusCode() shouldBe 200
                board.received().last { it != "getPercepts" } shouldBe "last"
                board.received() shouldNotContain "stop"
                mas.beliefs("bob") shouldNotContain "stop"
                mas.beliefs("bob") shouldContain "likes(tea)"
            }
        }
    }

    test("nothing moves for those who want nothing to move").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);") { _, _ ->
            val duration = "return getComputedStyle(document.getElementById('freeze')).transitionDuration"
            prefer("prefers-reduced-motion" to "no-preference")
            run<String>(duration) shouldBe "0.15s, 0.15s"
            prefer("prefers-reduced-motion" to "reduce")
            run<String>(duration) shouldBe "0s"
        }
    }

    context("words stand out from what is behind them") {
        listOf("light", "dark").forEach { scheme ->
            test("in the $scheme").config(tags = thorough, enabledOrReasonIf = browser) {
                shown("dist(f,38);dist(b,90);X;") { _, _ ->
                    prefer("prefers-color-scheme" to scheme, "prefers-reduced-motion" to "reduce")
                    press("dist(b,90)")
                    await { texts("#sensors .detail")[1].isNotEmpty() }
                    run<List<String>>(FAINT) shouldBe emptyList()
                }
            }
        }
    }

    test("every control has a name, and the console has no complaint").config(tags = thorough, enabledOrReasonIf = browser) {
        shown("dist(f,38);") { _, _ ->
            run<Long>("return [...document.querySelectorAll('button')].filter(b => !b.textContent.trim()).length") shouldBe 0
            run<Long>(
                """
                const label = section => document.getElementById(section.getAttribute('aria-labelledby'));
                return [...document.querySelectorAll('section')].filter(section => !label(section).textContent.trim()).length
                """,
            ) shouldBe 0
            complaints() shouldNotContain "SEVERE"
        }
    }
})

private infix fun List<String>.shouldContainText(part: String) = joinToString("\n") shouldContain part

/** Sends the requests of a page's buttons in every way that a page of another origin has, and then sets its own title. */
private const val ATTACK = """
    (async address => {
        const orders = {
            command: { command: 'stop' }, believe: { text: 'stop' }, begin: { text: 'long' }, forget: { text: 'likes(_)' },
            reload: {}, pause: {}, breakpoint: { place: 'bob.asl:6' },
        };
        await Promise.all(Object.entries(orders).map(([path, order]) => press(address + path, JSON.stringify(order))));
        document.title = 'all tried';

        async function press(address, body) {
            const form = document.body.appendChild(document.createElement('form'));
            const frame = document.body.appendChild(document.createElement('iframe'));
            Object.assign(frame, { name: address });
            Object.assign(form, { action: address, method: 'POST', enctype: 'text/plain', target: address });
            const field = form.appendChild(document.createElement('input'));
            Object.assign(field, { name: body.replace(/}$/, ',"x":"').replace('{,', '{'), value: '"}' });
            const loaded = new Promise(done => { // a browser may keep silent about a frame that was refused
                frame.addEventListener('load', done);
                setTimeout(done, 1000);
            });
            form.submit();
            await Promise.allSettled([
                loaded,
                fetch(address, { method: 'POST', mode: 'no-cors', body }),
                fetch(address, { method: 'POST', mode: 'no-cors', body, headers: { 'Content-Type': 'text/plain' } }),
                fetch(address, { method: 'POST', body, headers: { 'Content-Type': 'application/json' } }),
                fetch(address, { method: 'POST', body: new Blob([body], { type: 'application/json' }), credentials: 'include' }),
            ]);
            navigator.sendBeacon(address, new Blob([body], { type: 'application/json' }));
        }
    })"""

/** Finds words whose contrast with their background is less than WCAG 2.2 requires at level AA, 4.5 : 1. */
private const val FAINT = """
    const channel = c => (c /= 255) <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
    const numbers = colour => colour.match(/[\d.]+/g).map(Number);
    const luminance = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b);
    const behind = e => {
        for (; e; e = e.parentElement) {
            const c = numbers(getComputedStyle(e).backgroundColor);
            if (c.length < 4 || c[3] > 0) return c;
        }
        return [255, 255, 255];
    };
    const hasWords = e => [...e.childNodes].some(n => n.nodeType === 3 && n.textContent.trim());
    return [...document.querySelectorAll('body *')].filter(e => e.checkVisibility() && !e.disabled && hasWords(e)).flatMap(e => {
        const [a, b] = [luminance(numbers(getComputedStyle(e).color)), luminance(behind(e))].sort((x, y) => y - x);
        const ratio = (a + 0.05) / (b + 0.05);
        return ratio < 4.5 ? [e.textContent + ': ' + ratio.toFixed(2)] : [];
    });
"""

private val thorough = setOf(NamedTag("Thorough"))
