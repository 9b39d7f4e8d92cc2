package argo.ros

import argo.links.BoardLinkProvider
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.LineClock
import javino.NoSuchPortException

class RosAddressSpec : FunSpec({
    test("a port names a host, a TCP port and a mapping") {
        fun of(port: String) = RosAddress.of(port).let { "${it.socket} ${it.mapping}" }
        of("ros://robot.local:9091") shouldBe "ws://robot.local:9091/ robot"
        of("ros://robot") shouldBe "ws://robot:9090/ robot"
        of("ros://[::1]:9090/#left") shouldBe "ws://[::1]:9090/ left"
        of("ros://robot:8080/bridges/one#left") shouldBe "ws://robot:8080/bridges/one left"
        of("wss://robot.example/rosbridge") shouldBe "wss://robot.example:443/rosbridge robot"
        of("wss://robot:9090#left") shouldBe "wss://robot:9090/ left"
        listOf("ros:", "ros://", "ros://a:0", "ros://a:99999", "ros://a b:1", "ros://a:1/x y", "ws://a:1").forEach {
            shouldThrow<NoSuchPortException> { RosAddress.of(it) }
        }
    }

    test("whoever takes the address of a WebSocket for a port is told how it is written") {
        val provider = BoardLinkProvider.of("ws://robot:9090").shouldNotBeNull()
        shouldThrow<NoSuchPortException> { provider.open("ws://robot:9090", true, LineClock.system()) }.message shouldContain
            "\"ws://robot:9090\" names no robot: that is ros://HOST:PORT"
    }
})
