package argo.ros.serving

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private const val TOKEN = "0123456789abcdef"

class AccessSpec : FunSpec({
    fun refusalOf(text: String) = shouldThrow<RefusedServer> { Access.of(text) }.message.orEmpty()

    test("without a host, it is this computer's own address") {
        Access.of("9090").address.address.isLoopbackAddress shouldBe true
        Access.of(" 127.0.0.1:0 ").address.port shouldBe 0
    }
    test("an address that others reach needs a token that nobody guesses") {
        refusalOf("0.0.0.0:9090") shouldContain "give a token of at least 16 characters, as 0.0.0.0:9090?token=…"
        refusalOf("0.0.0.0:9090?token=short") shouldBe "a token has at least 16 characters"
        Access.of("0.0.0.0:9090?token=$TOKEN").address.port shouldBe 9090
        Access.of("0.0.0.0:9090", TOKEN).address.port shouldBe 9090
    }
    test("what is no address is refused") {
        listOf("", "robot", "99999", "127.0.0.1:99999", "ros://127.0.0.1:9090", "-1").forAll { refusalOf(it) shouldContain "is no address" }
        refusalOf("no.such.host.invalid:9090") shouldBe "there is no host no.such.host.invalid"
    }
    test("with a token, a client shows it in the path or in a header") {
        val access = Access.of("9090?token=$TOKEN")
        access.refusal("/?token=$TOKEN", null, "https://studio.example").shouldBeNull()
        access.refusal("/?a=b&token=$TOKEN", null, null).shouldBeNull()
        access.refusal("/", "Bearer $TOKEN", null).shouldBeNull()
        listOf("/", "/?token=", "/?token=%", "/?token=${TOKEN}0", "/?nottoken=$TOKEN").forAll {
            access.refusal(it, null, "http://localhost").shouldNotBeNull()
        }
    }
    test("without one, programs and pages of this computer come in, and pages of other sites do not") {
        val access = Access.of("9090")
        listOf(null, "", "http://localhost:8000", "http://127.0.0.1", "https://[::1]:3000")
            .forAll { access.refusal("/", null, it).shouldBeNull() }
        listOf("https://evil.example", "http://localhost.evil.example", "null", "http://127.0.0.1.evil.example:9090", "file://", "//")
            .forAll { access.refusal("/", null, it).shouldNotBeNull() }
    }
})
