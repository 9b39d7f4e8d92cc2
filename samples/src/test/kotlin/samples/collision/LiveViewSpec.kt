package samples.collision

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import samples.Program
import java.net.InetAddress
import java.net.ServerSocket
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.util.stream.Stream

@Tags("Thorough")
class LiveViewSpec : FunSpec({
    test("the robot waits for a browser, which is shown the run and how it ended") {
        Program.samples("collision", "--view", "--limit", "190").use { program ->
            val address = addressOf(program.awaitLine("live view: "))
            val states = watch(address).filter { it.startsWith("data: ") }.toList()
            val (status, printed) = program.awaitEnd()
            status shouldBe 0
            val verdict = printed.lines().last()
            verdict shouldContain "stopped"
            states.last() shouldContain "\"ended\":true"
            states.last() shouldContain "\"words\":\"$verdict\""
            states.dropLast(1).forEach { it shouldContain "\"ended\":false" }
            states.joinToString() shouldContain " cm – driving"
            states.joinToString() shouldContain "\"fate\":\"dropped\""
            states.joinToString() shouldContain "\"text\":\"front\""
        }
    }

    test("Enter starts the robot when no browser comes") {
        Program.samples("collision", "--view", "--view-wait", "3600", "--limit", "195").use { program ->
            program.awaitLine("live view: ")
            program.enter()
            program.awaitEnd().status shouldBe 0
        }
    }

    test("the robot does not wait for a browser longer than it is told") {
        Program.run("collision", "--view", "--view-wait", "0", "--limit", "195").status shouldBe 0
    }

    test("a run that is interrupted while it waits ends") {
        Program.samples("collision", "--view").use { program ->
            program.awaitLine("live view: ")
            program.interrupt().status shouldBe 130
        }
    }

    test("a port that is taken is said, and the robot drives without a view") {
        ServerSocket(0, 1, InetAddress.getByName("127.0.0.1")).use { taken ->
            val (status, printed) = Program.run("collision", "--view=${taken.localPort}", "--limit", "195")
            printed shouldContain "there is no live view, since port ${taken.localPort} is taken"
            status shouldBe 0
        }
    }
})

private fun addressOf(line: String) = URI(checkNotNull(Regex("http://127\\.0\\.0\\.1:\\d+/robot/").find(line)) { line }.value)

private fun watch(address: URI): Stream<String> =
    HttpClient.newHttpClient().send(HttpRequest.newBuilder(address.resolve("events")).build(), HttpResponse.BodyHandlers.ofLines()).body()
