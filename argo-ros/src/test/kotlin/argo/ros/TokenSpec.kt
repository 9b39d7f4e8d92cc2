package argo.ros

import argo.ros.bridge.login
import argo.ros.bridge.operationIn
import argo.ros.mapping.Credentials
import argo.ros.mapping.MappingException
import argo.ros.mapping.findCredentials
import argo.ros.mapping.mappingOf
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import javino.LineClock
import javino.NoSuchPortException
import javino.PortFaultException
import java.net.URI
import java.nio.file.Path
import kotlin.io.path.writeText

private const val TOKEN = "quite-a-long-secret"

class TokenSpec : FunSpec({
    test("a bridge that wants a token gets it, and none is a fault") {
        TestBridge(token = TOKEN).use { bridge ->
            val address = URI("ws://127.0.0.1:${bridge.number}/")
            val mapping = mappingOf("percepts:\n  - /hit std_msgs/Bool", "robot.ros.yaml")

            fun open(token: String?) = RosLink.open("robot", address, mapping, true, LineClock.system(), Credentials(token))
            open(TOKEN).use { it.isOpen shouldBe true }
            shouldThrow<PortFaultException> { open(null) }
            shouldThrow<PortFaultException> { open("another-long-secret") }.message.orEmpty() shouldNotContain "another-long-secret"
        }
    }

    test("a bridge that has a secret in common gets a login before all else, and no secret") {
        TestBridge().use { bridge ->
            val credentials = Credentials(secret = "abcdefghijklmnop")
            val mapping = mappingOf("percepts:\n  - /hit std_msgs/Bool", "robot.ros.yaml")
            RosLink.open("robot", URI("ws://127.0.0.1:${bridge.number}/"), mapping, true, LineClock.system(), credentials).close()
            bridge.heard.first().keys shouldBe setOf("op", "mac", "client", "dest", "rand", "t", "level", "end")
            "${bridge.heard}" shouldNotContain "abcdefghijklmnop"
        }
    }

    test("a login is as the package rosauth checks it") {
        // computed with: echo -n abcdefghijklmnopargorobotr1000user1060 | sha512sum
        val mac = operationIn(login("abcdefghijklmnop", "robot", 1000, "r"))!!["mac"].toString().trim('"')
        mac.take(16) shouldBe "a3df02b08841e511"
    }

    test("the token stands in a file beside the mapping, and in no name of a port") {
        val directory = tempdir().toPath()
        fun findToken(name: String, directory: Path) = findCredentials(name, directory).token
        findToken("left", directory) shouldBe null
        directory.resolve("left.ros.token").writeText("$TOKEN\n")
        findToken("left", directory) shouldBe TOKEN
        directory.resolve("left.ros.token").writeText("two words\n")
        shouldThrow<MappingException> { findToken("left", directory) }.message.orEmpty().let {
            it shouldContain "it holds no token"
            it shouldNotContain "two words"
        }
        shouldThrow<NoSuchPortException> { RosAddress.of("ros://robot:9090?token=$TOKEN") }.message.orEmpty().let {
            it shouldContain "robot.ros.token"
            it shouldNotContain TOKEN
        }
    }
})
