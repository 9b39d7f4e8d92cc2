package argo.tools.migration

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class TokensSpec : FunSpec({
    fun calls(text: String) = callsIn(tokensOf(text)).map { it.name to it.line }

    test("calls are found with their dots and lines, whatever stands in between") {
        calls("+!a <- .argo.port(x);\n  argo.limit( 20 ) ; .act\n(front).") shouldContainExactly
            listOf(".argo.port" to 1, "argo.limit" to 2, ".act" to 2)
    }

    test("comments and strings hold no calls") {
        calls("// .argo.port(a)\n/* argo.act(b)\n */ .print(\".act(c) \\\" .act(d)\", '.act(e)'). // argo.act(f)") shouldContainExactly
            listOf(".print" to 3)
    }

    test("a string without an end ends with its line, a comment without one with the text") {
        calls(".print(\"oops);\n.act(x). /* .act(y)") shouldContainExactly listOf(".print" to 1, ".act" to 2)
    }

    test("the end of a plan is no part of the next name") {
        calls("+a <- .act(x).\nport(y,on).") shouldContainExactly listOf(".act" to 1, "port" to 2)
        calls("+a <- b.port(x)") shouldContainExactly listOf("b.port" to 1)
    }

    test("arguments are separated outside brackets") {
        val call = callsIn(tokensOf("f(g(a,b),[c,d],\"e,f\",H)")).first()
        call.arguments.map { argument -> argument.joinToString("") { it.text } } shouldContainExactly
            listOf("g(a,b)", "[c,d]", "\"e,f\"", "H")
        callsIn(tokensOf("f()")).single().arguments shouldBe emptyList()
    }

    test("no text makes it throw, and every token stands where it says") {
        val part = Arb.element("(", ")", ",", ".", "a", "\"", "'", "\\", "\n", "/*", "*/", "//", " ", "port", "9", "é", "\uD83D\uDE00", "[")
        checkAll(Arb.list(part, 0..40)) { parts ->
            val text = parts.joinToString("")
            val tokens = tokensOf(text)
            tokens.forEach { token ->
                text.substring(token.start, token.end) shouldBe token.text
                token.line shouldBe 1 + text.take(token.start).count { it == '\n' }
            }
            callsIn(tokens)
        }
    }
})
