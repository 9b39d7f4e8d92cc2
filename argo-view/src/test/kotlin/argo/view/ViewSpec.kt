package argo.view

import argo.observing.ObservedAgent
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import jason.architecture.MindInspectorWeb
import javino.sim.FakeBoard
import java.net.Inet4Address
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.NetworkInterface
import java.net.ServerSocket
import java.net.Socket
import java.net.URI
import java.util.concurrent.atomic.AtomicInteger
import java.util.logging.Logger

private const val LOOKS = """
    !start.
    +!start <- argo.port("sim:robot", [baud(1000000)]); argo.limit(20); argo.change_filter(front); argo.percepts(open); argo.act(hello).
"""

/** Percepts that make a message of the largest possible length. */
private val FILLING = "a(1);b(2);c(3);d(\"${"x".repeat(180)}\");"
private const val FRONT = """
    <PerceptionFilter>
      <filter><predicate>dist</predicate><parameter id="0" operator="NE">f</parameter></filter>
    </PerceptionFilter>
"""

class ViewSpec : FunSpec({
    suspend fun watched(
        program: String = LOOKS,
        answer: String = "dist(f,38);dist(b,90);light(4);",
        test: suspend (ViewedMas, FakeBoard, URI) -> Unit,
    ) =
        FakeBoard.plugIn("robot").use { board ->
            board.lenient().whenAsked("getPercepts").answer(answer)
            ViewedMas().use { mas ->
                mas.file("front.xml", FRONT)
                mas.file("filters/wrong.xml", "<PerceptionFilter><filter/></PerceptionFilter>")
                mas.file("filters/doubled.json", """{"rules": [{"predicate": "dist"}, {"predicate": "dist"}]}""")
                mas.agent("bob", program)
                test(mas, board, mas.viewOf("bob"))
            }
        }

    test("a page is told of ports, sensors, the filter's decisions, beliefs and commands") {
        watched { _, _, address ->
            Watcher(address).use { watcher ->
                val state = watcher.await {
                    it.sensors.percepts.any { p -> p.fate == "dropped" } && it.commands.finished.isNotEmpty() &&
                        it.beliefs.beliefs.size == 3
                }
                listOf(state.agent, state.policy, state.intervalMs, state.perceiving, state.ended) shouldBe
                    listOf("bob", "fresh", 20, true, false)
                state.ports.map { listOf(it.name, it.status, it.inUse) } shouldBe listOf(listOf("\"sim:robot\"", "on", true))
                state.filter.shouldNotBeNull().name shouldBe "front"
                state.sensors.percepts.map { it.text to it.fate } shouldBe
                    listOf("dist(f,38)" to "kept", "dist(b,90)" to "dropped", "light(4)" to "kept")
                state.beliefs.beliefs.map { it.text }.shouldContainExactlyInAnyOrder("port(\"sim:robot\",on)", "dist(f,38)", "light(4)")
                state.commands.finished.map { it.text to it.state } shouldBe listOf("hello" to "done")
                state.picture.shouldBeNull()
                watcher.await { (it.rates?.frames ?: 0.0) > 1 }
            }
        }
    }

    test("a page is told who watches each critical rule, and what became of its reflex") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient().version2().holdsRules(1).whenAsked("getPercepts").answer("dist(f,9);temp(99);")
            ViewedMas().use { mas ->
                val near = "<critical reflex='stop'><predicate>dist</predicate><parameter id='1' operator='LT'>15</parameter></critical>"
                val hot = """<critical reflex="fan"><predicate>temp</predicate><parameter id="0" operator="GT">80</parameter></critical>"""
                mas.file("front.xml", "<PerceptionFilter>$near$hot</PerceptionFilter>")
                mas.agent("bob", LOOKS)
                Watcher(mas.viewOf("bob")).use { watcher ->
                    val rules = watcher.await { state ->
                        state.critical.map { it.watcher to it.reflex } == listOf("board" to "done", "computer" to "done")
                    }.critical
                    rules.map { it.rule } shouldBe listOf(
                        "dist where argument 1 is less than 15, with the reflex stop",
                        "temp where argument 0 is greater than 80, with the reflex fan",
                    )
                    rules.last().by shouldBe "computer"
                    rules.map { it.error } shouldBe listOf(null, null)
                }
            }
        }
    }

    test("a page that is opened later is told what an idle agent believes") {
        watched("likes(tea).\n!start.\n+!start <- +ready.") { mas, _, address ->
            mas.awaitBelief("bob", "ready")
            Watcher(address).use { watcher ->
                watcher.await { it.beliefs.beliefs.map { belief -> belief.text }.containsAll(listOf("likes(tea)", "ready")) }
            }
        }
    }

    test("the filter is changed by name, to none and back, and the agent follows") {
        watched { mas, _, address ->
            Watcher(address).use { watcher ->
                watcher.await { it.filter?.name == "front" }
                address.post("filter", """{"name":"doubled"}""").statusCode() shouldBe 200
                val warning = ". Warning: rule 2 (dist) has no effect: rule 1 (dist) matches the same percepts"
                watcher.await { it.filter?.words.orEmpty().endsWith(warning) }
                address.post("filter", """{"name":null}""").statusCode() shouldBe 200
                watcher.await { it.filter == null && it.sensors.percepts.all { p -> p.fate == "kept" } && it.sensors.percepts.size == 3 }
                mas.awaitBelief("bob", "dist(b,90)")
                address.post("filter", """{"name":"front"}""").statusCode() shouldBe 200
                eventually(LIMIT) { mas.beliefs("bob") shouldNotContain "dist(b,90)" }
                address.post("filter", """{"name":"none"}""").body() shouldContain "perceives everything"
                mas.awaitBelief("bob", "dist(b,90)")
            }
        }
    }

    test("the filters that there are are listed; one that is not there, or refused, changes nothing and says why") {
        watched { _, _, address ->
            Watcher(address).use { watcher ->
                watcher.await { it.filter?.name == "front" }
                with(address.get("filters").body()) {
                    this shouldContain "\"front\""
                    this shouldContain "\"wrong\""
                }
                with(address.post("filter", """{"name":"elsewhere"}""")) {
                    statusCode() shouldBe 404
                    body() shouldContain "There is no filter 'elsewhere'"
                }
                with(address.post("filter", """{"name":"wrong"}""")) {
                    statusCode() shouldBe 422
                    body() shouldContain "predicate"
                }
                address.post("filter", """{"name":"../front"}""").statusCode() shouldBe 404
                watcher.await { it.filter != null }.filter.shouldNotBeNull().name shouldBe "front"
            }
        }
    }

    test("perception is blocked and opened") {
        watched { _, _, address ->
            Watcher(address).use { watcher ->
                watcher.await { it.sensors.percepts.isNotEmpty() }
                address.post("percepts", """{"open":false}""").statusCode() shouldBe 200
                watcher.await { !it.perceiving }
                address.post("percepts", """{"open":true}""").statusCode() shouldBe 200
                val frames = watcher.await { it.perceiving }.sensors.frameAgeMs.shouldNotBeNull()
                watcher.await { it.sensors.frameAgeMs.shouldNotBeNull() < frames + 1000 }
            }
        }
    }

    test("why a percept is kept or dropped is told on demand") {
        watched { _, _, address ->
            Watcher(address).use { it.await { state -> state.filter != null } }
            address.get("explain?percept=dist(b,90)").body() shouldContain "dist(b,90) is dropped by filter front: it matches rule 1"
            address.get("explain?percept=light(4)").body() shouldContain "is kept by filter front"
            address.get("explain?percept=%22").body() shouldContain "not a percept"
            address.raw("GET /explain?percept=%zz HTTP/1.1", "Host: ${address.authority}") shouldContain "400"
            address.get("explain").statusCode() shouldBe 400
        }
    }

    test("requests of other pages and under other names are refused and change nothing") {
        watched { _, _, address ->
            Watcher(address).use { watcher ->
                watcher.await { it.filter?.name == "front" }
                address.post("filter", """{"name":null}""", "Origin" to "http://robot.example").statusCode() shouldBe 403
                address.post("filter", """{"name":null}""", "Origin" to "null").statusCode() shouldBe 403
                address.post("filter", """{"name":null}""", "Sec-Fetch-Site" to "cross-site").statusCode() shouldBe 403
                address.post("filter", """{"name":null}""", "Content-Type" to "text/plain").statusCode() shouldBe 415
                val json = arrayOf("Content-Type: application/json", "Content-Length: 13", "", """{"name":null}""")
                address.raw("POST ${address.path}filter HTTP/1.1", "Host: robot.example:${address.port}", *json) shouldContain "403"
                address.raw("GET ${address.path}events HTTP/1.1", "Host: robot.example:${address.port}") shouldContain "403"
                address.raw("GET / HTTP/1.1", "Host: robot.example") shouldContain "403"
                address.raw("GET ${address.path} HTTP/1.1", "Host: localhost:${address.port}") shouldContain "200"
                watcher.await { true }.filter.shouldNotBeNull().name shouldBe "front"
                address.post("filter", """{"name":null}""", "Origin" to "http://${address.authority}").statusCode() shouldBe 200
            }
        }
    }

    test("what nobody can mean is refused with the reason") {
        watched { mas, _, address ->
            address.get("nothing").statusCode() shouldBe 404
            address.raw("GET /bob/../view.js HTTP/1.1", "Host: ${address.authority}") shouldContain "404"
            address.get("filter").statusCode() shouldBe 405
            address.raw("HEAD /bob/ HTTP/1.1", "Host: ${address.authority}") shouldContain "405"
            mas.log shouldNotContain "com.sun.net.httpserver" // the server's library warns the user of what is no mistake
            address.post("filters", "{}").statusCode() shouldBe 405
            address.post("", "{}").statusCode() shouldBe 405
            address.post("events", "{}").statusCode() shouldBe 405
            address.post("filter", "x").statusCode() shouldBe 400
            address.post("filter", "{}").statusCode() shouldBe 400
            address.post("percepts", """{"open":"perhaps"}""").statusCode() shouldBe 400
            address.post("filter", "\"" + "x".repeat(20_000) + "\"").statusCode() shouldBe 413
        }
    }

    test("the page needs nothing from anywhere else, and no browser puts it into another page") {
        watched { _, _, address ->
            for (path in listOf("", "/view.css", "/view.js", "/course.js")) {
                val answer = address.get(path)
                answer.statusCode() shouldBe 200
                answer.body().replace("http://www.w3.org/2000/svg", "") shouldNotContain "//www" // a namespace's name loads nothing
                answer.body() shouldNotContain "https:"
                val policy = answer.headers().firstValue("Content-Security-Policy").get()
                policy shouldContain "default-src 'none'"
                policy shouldContain "frame-ancestors 'none'"
                policy shouldNotContain "unsafe"
            }
        }
    }

    test("a page is told of intentions with their plans and what they wait for, and of what is printed") {
        val program = """
            !start.
            +!start <- .print("on my way"); !rest(9).
            +!rest(N)
              <- .wait(600000).
            +!other <- .suspend.
        """.trimIndent()
        watched(program) { mas, _, address ->
            Watcher(address).use { watcher ->
                val state = watcher.await { it.intentions.intentions.any { one -> one.state == "waiting" } && it.printed.isNotEmpty() }
                with(state.intentions.intentions.single()) {
                    waitsFor shouldBe ".wait(600000)"
                    plans shouldBe listOf(PlanState("+!rest(9)", "bob.asl", 3), PlanState("+!start", "bob.asl", 2))
                }
                state.printed.map { it.text } shouldBe listOf("on my way")
                mas.achieve("bob", "other")
                val both = watcher.await { it.intentions.total == 2 && it.intentions.intentions.any { one -> one.state == "suspended" } }
                both.intentions.intentions.last().plans.map { it.trigger } shouldBe listOf("+!other")
                mas.achieve("bob", "unknown")
                watcher.await { it.printed.any { line -> line.warning && "unknown" in line.text } }
            }
        }
    }

    test("a page that is opened later is told the course of each number meanwhile") {
        watched { _, board, address ->
            fun messages() = board.received().count { it == "getPercepts" }
            eventually(LIMIT) { messages() shouldBeGreaterThan 60 } // 20 ms each, so the course has values of at least two half seconds
            Watcher(address).use { watcher ->
                val courses = watcher.await { it.courses != null }.courses.shouldNotBeNull()
                courses.values.map { it.single().last { value -> value != null } } shouldBe listOf(38.0, 90.0, 4.0)
                courses.values.first().single().count { it != null } shouldBeGreaterThan 1
            }
        }
    }

    test("a command by hand goes to the board, and its outcome is the response") {
        watched { _, board, address ->
            Watcher(address).use { watcher ->
                watcher.await { it.commands.finished.isNotEmpty() }
                with(address.post("command", """{"command":"speed(12)"}""")) { statusCode() to body() } shouldBe
                    (200 to """{"message":"speed(12): done"}""")
                board.received() shouldContain "speed(12)"
                watcher.await { state -> state.commands.finished.first().run { text == "speed(12)" && this.state == "done" } }
                with(address.post("command", """{"command":"speed("}""")) {
                    statusCode() shouldBe 422
                    body() shouldContain "wrong_arguments"
                }
                address.post("command", """{"command":7}""").statusCode() shouldBe 400
                address.get("command").statusCode() shouldBe 405
            }
        }
    }

    test("other pages, and who does not send JSON, cannot order the agent to do anything, nor send a command") {
        watched { mas, board, address ->
            val orders = listOf("believe", "forget", "begin", "drop", "reload", "pause", "go", "step", "until", "breakpoint")
            (orders.map { it to """{"text":"likes(milk)"}""" } + ("command" to """{"command":"stop"}""")).forEach { (path, order) ->
                address.post(path, order, "Origin" to "http://robot.example").statusCode() shouldBe 403
                address.post(path, order, "Origin" to "null").statusCode() shouldBe 403
                address.post(path, order, "Sec-Fetch-Site" to "cross-site").statusCode() shouldBe 403
                address.post(path, order, "Sec-Fetch-Site" to "same-site").statusCode() shouldBe 403
                address.post(path, order, "Content-Type" to "text/plain").statusCode() shouldBe 415
            }
            address.post("believe", """{"text":"last"}""").statusCode() shouldBe 200
            address.post("command", """{"command":"last"}""").statusCode() shouldBe 200
            mas.beliefs("bob") shouldContain "last"
            mas.beliefs("bob") shouldNotContain "likes(milk)"
            board.received() shouldNotContain "stop"
        }
    }

    test("of more agents than there is room for, the number is told") {
        val site = Site()
        (1..203).forEach { site.add(AgentPage(object : ObservedAgent by Nobody { override val name = "scout$it" })) }
        val (tabs, more) = site.tabs()
        tabs.size to more shouldBe (200 to 3)
    }

    test("agents with the same port share it, each with a page of its own that names the others") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            ViewedMas().use { mas ->
                val port = ServerSocket(0, 1, InetAddress.getByName("127.0.0.1")).use { it.localPort }
                mas.agent("ann", "likes(tea).", mapOf("argo_view" to "$port"))
                mas.agent("bob", "likes(milk).", mapOf("argo_view" to "$port"))
                val (ann, bob) = listOf("ann", "bob").map(mas::viewOf)
                listOf(ann.path, bob.path, "${ann.port}", "${bob.port}") shouldBe listOf("/ann/", "/bob/", "$port", "$port")
                Watcher(bob).use { watcher ->
                    val state = watcher.await { it.agents.size == 2 && it.beliefs.beliefs.isNotEmpty() }
                    state.agent shouldBe "bob"
                    state.agents.map { it.name } shouldBe listOf("ann", "bob")
                    state.beliefs.beliefs.map { it.text } shouldBe listOf("likes(milk)")
                    with(bob.get("/")) { statusCode() to headers().firstValue("Location").get() } shouldBe (303 to "/ann/")
                    mas.kill("ann")
                    watcher.await { it.agents.size == 1 }
                    bob.get("/ann/").statusCode() shouldBe 404
                    bob.get("").statusCode() shouldBe 200
                }
                mas.kill("bob")
                eventually(LIMIT) { viewThreads().shouldBeEmpty() }
                ServerSocket(port, 1, InetAddress.getByName("127.0.0.1")).close()
            }
        }
    }

    test("an agent with any name has a page") {
        ViewedMas().use { mas ->
            mas.agent("a b/ü+%", "likes(tea).")
            val address = mas.agentView("a b/ü+%").address
            Watcher(address).use { it.await { state -> state.agent == "a b/ü+%" } }
        }
    }

    test("the server listens on this computer's own address only") {
        watched { _, _, address ->
            address.host shouldBe "127.0.0.1"
            val own = NetworkInterface.networkInterfaces().toList().flatMap { it.inetAddresses().toList() }
            own.filter { !it.isLoopbackAddress && it is Inet4Address }.forEach { other ->
                runCatching { Socket(other, address.port).close() }.isFailure shouldBe true
            }
        }
    }

    test("Jason's mind inspector beside views, which listens on all addresses, is told of once, with its address") {
        ViewedMas().use { mas ->
            mas.agent("alice", "a.")
            ("mind inspector" in mas.log) shouldBe false
            MindInspectorWeb.get()
            try {
                listOf("bob", "carol").forEach { mas.agent(it, "a.") }
                val told = mas.log.lines().filter { "mind inspector" in it }
                told.single() shouldContain "at ${MindInspectorWeb.getURL()}, listens on all network addresses"
            } finally {
                MindInspectorWeb.stop()
            }
        }
    }

    test("a browser that does not read holds up neither the agent nor another browser") {
        watched(program = LOOKS + "+light(X) <- argo.act(seen(X)).") { _, board, address ->
            Socket().use {
                it.receiveBufferSize = 1024
                it.connect(InetSocketAddress("127.0.0.1", address.port))
                it.getOutputStream().write("GET ${address.path}events HTTP/1.1\r\nHost: ${address.authority}\r\n\r\n".toByteArray())
                val frames = AtomicInteger()
                board.whenAsked("getPercepts").answer { "light(${frames.incrementAndGet()});" + FILLING }
                Watcher(address).use { watcher ->
                    eventually(LIMIT) { board.received().count { it.startsWith("seen") } shouldBeGreaterThan 50 }
                    val now = frames.get()
                    val light = Regex("""light\((\d+)\)""")
                    watcher.await { state ->
                        state.sensors.percepts.mapNotNull { light.matchEntire(it.text)?.groupValues?.get(1) }.any { it.toInt() > now }
                    }
                }
            }
        }
    }

    test("several browsers watch several agents, each what it asked for") {
        FakeBoard.plugIn("robot").use { board ->
            board.lenient()
            ViewedMas().use { mas ->
                mas.agent("ann", "likes(tea).")
                mas.agent("bob", "likes(milk).")
                listOf("ann" to "likes(tea)", "bob" to "likes(milk)").forEach { (agent, belief) ->
                    val watchers = (1..3).map { Watcher(mas.viewOf(agent)) }
                    watchers.forEach { it.await { state -> state.agent == agent && state.beliefs.beliefs.any { b -> b.text == belief } } }
                    watchers.forEach(Watcher::close)
                }
            }
        }
    }

    test("a project's picture is shown, and one that cannot be had costs nothing else") {
        watched { mas, _, address ->
            Watcher(address).use { watcher ->
                val view = mas.agentView("bob")
                view.address shouldBe address
                val asked = AtomicInteger()
                view.show { Picture("<svg/>", "driving ${asked.incrementAndGet()}") }
                watcher.await { it.picture?.svg == "<svg/>" && it.picture.words != "driving 1" }
                view.show { throw NoSuchElementException("no robot") }
                watcher.await { it.picture == null }
                mas.log shouldContain "the live view shows no picture any more"
                view.show { Picture("<svg/>", "stopped") }
                mas.kill("bob")
                watcher.await { it.ended }.picture?.words shouldBe "stopped"
            }
        }
    }

    test("the picture is asked for when a page is open, and not before") {
        watched { mas, _, address ->
            val asked = AtomicInteger()
            mas.agentView("bob").show { null.also { asked.incrementAndGet() } }
            mas.awaitBelief("bob", "light(4)")
            asked.get() shouldBe 0
            Watcher(address).use { eventually(LIMIT) { asked.get() shouldBeGreaterThan 0 } }
        }
    }

    test("more pages than there is room for are told so") {
        watched { _, _, address ->
            val watchers = (1..12).map { Watcher(address).apply { await { true } } }
            address.get("events").statusCode() shouldBe 503
            watchers.forEach(Watcher::close)
            eventually(LIMIT) { address.raw("GET ${address.path}events HTTP/1.1", "Host: ${address.authority}") shouldContain "200" }
        }
    }

    test("a state that cannot be shown is told once, and the view goes on") {
        ViewedMas().use { mas ->
            mas.agent("bob", "!start.\n+!start <- +ready.")
            mas.awaitBelief("bob", "ready")
            val bob = mas.observed("bob")
            val calls = AtomicInteger()
            val broken = object : ObservedAgent by bob {
                override fun ports() = if (calls.incrementAndGet() <= 3) error("no ports today") else bob.ports()
            }
            AgentView(broken, 0, Logger.getLogger("argo.view.broken")).use { view ->
                Watcher(view.address).use { watcher -> watcher.await { it.agent == "bob" && it.ports.isEmpty() } }
            }
            calls.get() shouldBeGreaterThan 3
            Regex("misses a state").findAll(mas.log).count() shouldBe 1
        }
    }

    test("when the agent ends, the page is told and nothing is left: no thread, no port") {
        watched { mas, _, address ->
            Watcher(address).use { watcher ->
                watcher.await { it.sensors.percepts.isNotEmpty() }
                mas.kill("bob")
                watcher.await { it.ended }
                watcher.awaitEnd()
            }
            eventually(LIMIT) { viewThreads().shouldBeEmpty() }
            ServerSocket(address.port, 1, InetAddress.getByName("127.0.0.1")).close()
        }
    }

    test("50 agents with views that are watched and killed leave no thread").config(tags = thorough) {
        ViewedMas().use { mas ->
            (1..50).forEach { mas.agent("bob$it", "likes(tea).") }
            val watchers = (1..50 step 5).map { Watcher(mas.viewOf("bob$it")).apply { await { true } } }
            (1..50).forEach { mas.kill("bob$it") }
            eventually(LIMIT) { viewThreads().shouldBeEmpty() }
            watchers.forEach(Watcher::close)
        }
    }

    test("a port that is taken is reported, and the agent runs without a view") {
        ServerSocket(0, 1, InetAddress.getByName("127.0.0.1")).use { taken ->
            ViewedMas().use { mas ->
                mas.agent("bob", "!start.\n+!start <- +ready.", mapOf("argo_view" to "${taken.localPort}"))
                mas.awaitBelief("bob", "ready")
                mas.log shouldContain "argo_view=${taken.localPort}: port ${taken.localPort} cannot be had"
            }
        }
    }

    context("a view that cannot be meant is reported, and the agent runs without") {
        listOf("true", "-1", "65536", "80 80", "\"\"", "8080.5").forEach { word ->
            test("argo_view=$word") {
                ViewedMas().use { mas ->
                    mas.agent("bob", "!start.\n+!start <- +ready.", mapOf("argo_view" to word))
                    mas.awaitBelief("bob", "ready")
                    mas.log shouldContain "a view has the number of a port from 0 to 65535"
                    viewThreads() shouldBe emptyList()
                }
            }
        }
    }
})

private fun viewThreads(): List<String> =
    Thread.getAllStackTraces().keys.map { it.name }.filter { "-view" in it || it == "HTTP-Dispatcher" }

private val thorough = setOf(NamedTag("Thorough"))
