package argo.tools.reloading

import argo.tools.Output
import argo.tools.argo
import com.sun.net.httpserver.HttpServer
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.net.InetAddress
import java.net.InetSocketAddress

/** Live views of the agents robot and "a b", with the responses of argo.view.ViewServer. */
private class Views : AutoCloseable {
    private val server = HttpServer.create(InetSocketAddress(InetAddress.getByName("127.0.0.1"), 0), 0)
    val answers = hashMapOf("/robot/reload" to (200 to "1 plan changed"), "/a%20b/reload" to (200 to "nothing has changed"))
    val asked = ArrayList<String>()
    var agents = """{"agents":["a b","robot"]}"""
    val port get() = server.address.port

    init {
        server.createContext("/") { exchange ->
            val path = exchange.requestURI.rawPath
            val body = exchange.requestBody.readAllBytes().decodeToString()
            asked += "${exchange.requestMethod} $path ${exchange.requestHeaders.getFirst("Content-Type")} $body"
            val (status, words) = answers[path] ?: (200 to "")
            val answer = if (path == "/agents") agents else """{"message":"$words"}"""
            exchange.sendResponseHeaders(status, answer.length.toLong())
            exchange.responseBody.use { it.write(answer.toByteArray()) }
        }
        server.start()
    }

    override fun close() = server.stop(0)
}

class ReloadCommandSpec : FunSpec({
    test("an agent is reloaded, and tells what has changed") {
        Views().use { views ->
            argo("reload", "robot", "--view", "${views.port}") shouldBe Output(0, "robot: 1 plan changed\n", "")
            views.asked.last() shouldBe "POST /robot/reload application/json {}"
        }
    }

    test("without a name all agents of the port are reloaded") {
        Views().use { views ->
            argo("reload", "--view", "${views.port}").out shouldBe "a b: nothing has changed\nrobot: 1 plan changed\n"
        }
    }

    test("a mistake in a file, or an agent that does not answer, is a failure, with its words") {
        Views().use { views ->
            views.answers["/robot/reload"] = 422 to "robot.asl, line 3: no plan\\nthe agent goes on"
            argo("reload", "robot", "--view", "${views.port}") shouldBe
                Output(1, "", "robot: robot.asl, line 3: no plan\nthe agent goes on\n")
            views.answers["/robot/reload"] = 202 to "the agent does it in its next reasoning cycle"
            with(argo("reload", "--view", "${views.port}")) {
                status shouldBe 1
                out shouldBe "a b: nothing has changed\n"
                err shouldStartWith "robot: the agent does it in its next"
            }
        }
    }

    test("an agent that is not there is refused with those that are") {
        Views().use { views ->
            argo("reload", "rob", "--view", "${views.port}") shouldBe
                Output(1, "", "there is no agent rob at http://127.0.0.1:${views.port}/; there are: a b, robot\n")
            views.agents = """{"agents":["\u001b[2J"]}"""
            argo("reload", "rob", "--view", "${views.port}").err shouldContain "there are: \\x1B[2J\n"
        }
    }

    test("what a view does not tell is told: no program, another program, no port") {
        val port = Views().use { it.port }
        with(argo("reload", "--view", "$port")) {
            status shouldBe 1
            err shouldStartWith "no live view responds at http://127.0.0.1:$port/ (nothing listens there)"
            err shouldContain "argo_view=$port"
        }
        Views().use { views ->
            views.agents = "<html>"
            argo("reload", "--view", "${views.port}").err shouldContain "is no live view of this version of ARGO"
            views.asked.filter { it.startsWith("POST") }.shouldBeEmpty()
        }
        argo("reload", "--view", "0").err shouldStartWith "--view is from 1 to 65535, not 0"
    }
})
