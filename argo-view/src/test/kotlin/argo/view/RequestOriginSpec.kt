package argo.view

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class RequestOriginSpec : FunSpec({
    fun refusal(host: String? = "127.0.0.1:8080", origin: String? = null, fetchSite: String? = null, isPage: Boolean = false) =
        RequestOrigin.refusal(host, origin, fetchSite, isPage)

    context("a request is let in under the host name") {
        listOf("127.0.0.1:8080", "localhost:8080", "LOCALHOST:9", "127.0.0.1", "[::1]:8080").forEach { host ->
            test(host) { refusal(host) shouldBe null }
        }
    }

    context("a request is refused under the host name") {
        listOf(
            "robot.example:8080", "127.0.0.1.example:8080", "example/127.0.0.1:8080", "localhost.example", "127.0.0.1:8080@example",
            "127.0.0.10:8080",
            "127.0.0.1:", "", "a127.0.0.1", "127.0.0.1\n", "localhost:8080.example",
        ).forEach { host ->
            test(host.ifEmpty { "(empty)" }.trim() + if (host.endsWith("\n")) " and a line break" else "") {
                refusal(host).shouldNotBeNull() shouldContain "127.0.0.1"
            }
        }
    }

    test("a request without a host name is refused") { refusal(host = null).shouldNotBeNull() }

    test("the page's own requests are let in") {
        refusal(origin = "http://127.0.0.1:8080", fetchSite = "same-origin") shouldBe null
        refusal(host = "localhost:8080", origin = "http://localhost:8080") shouldBe null
        refusal(fetchSite = "none") shouldBe null
    }

    context("a request of another page is refused") {
        val others = listOf("http://robot.example", "null", "http://localhost:8080", "http://127.0.0.1:8081", "https://127.0.0.1:8080", "")
        others.forEach { origin ->
            test("origin $origin") { refusal(origin = origin).shouldNotBeNull() shouldContain "another page" }
        }
        listOf("cross-site", "same-site").forEach { site ->
            test("fetched $site") { refusal(fetchSite = site).shouldNotBeNull() shouldContain "another page" }
        }
    }

    test("a link on another page may lead to the page itself") { refusal(fetchSite = "cross-site", isPage = true) shouldBe null }
})
