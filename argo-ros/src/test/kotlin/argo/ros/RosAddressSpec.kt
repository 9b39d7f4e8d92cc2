package argo.ros

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
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
})
