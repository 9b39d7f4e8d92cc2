package argo.filters

import argo.filters.format.JsonFilters
import argo.filters.format.XmlFilters
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import io.kotest.matchers.string.shouldNotContain

class FilterExceptionSpec : FunSpec({
    val deep = "f(".repeat(50_000) + "a" + ")".repeat(50_000)

    fun xml(parts: String) = shouldThrow<FilterException> {
        XmlFilters.read("<PerceptionFilter><filter><predicate>dist</predicate>$parts</filter></PerceptionFilter>", "f.xml")
    }

    fun json(parts: String) = shouldThrow<FilterException> { JsonFilters.read("{\"rules\": [{\"predicate\": \"d\", $parts}]}", "f.json") }

    test("a long value is shown with its beginning and its end, and the expectation stays") {
        val refused = xml("<parameter id=\"0\">$deep</parameter>")
        val message = refused.problems.single().message
        message shouldContain "'f(f(f("
        message shouldContain " characters …))"
        message shouldEndWith ")))' is not a value that Jason can read: " +
            "an atom (front), a number (-3.5), a string (\"text\"), a structure (pos(1,2)) or a list ([a,b])"
        refused.message shouldBe "f.xml:1:72: $message"
    }

    val long = "word ".repeat(20_000) + "'word'"
    mapOf(
        "a predicate" to { xml("<predicate>$long</predicate>") },
        "an operator" to { xml("<parameter id=\"0\" operator=\"$long\">1</parameter>") },
        "an argument's number" to { xml("<parameter id=\"$long\">1</parameter>") },
        "a name" to { xml("<${"p".repeat(100_000)}/>") },
        "text between elements" to { xml(long) },
        "a reflex" to {
            shouldThrow<FilterException> { XmlFilters.read("<PerceptionFilter><critical reflex=\"$long\"/></PerceptionFilter>", "") }
        },
        "an element that is not closed" to { xml("<${"p".repeat(100_000)}>") },
        "an encoding" to {
            shouldThrow<FilterException> {
                XmlFilters.read("<?xml version=\"1.0\" encoding=\"${"x".repeat(100_000)}\"?>".toByteArray().inputStream(), "")
            }
        },
        "a list of values" to { json("\"conditions\": [{\"argument\": 0, \"operator\": \"IN\", \"value\": \"$long\"}]") },
        "a pattern" to { json("\"conditions\": [{\"argument\": 0, \"operator\": \"MATCHES\", \"value\": \"($long\"}]") },
        "a member" to { json("\"$long\": 1") },
        "a token" to { json(deep.replace("(", "")) },
    ).forEach { (what, refused) ->
        test("the message stays short, however long is $what") {
            val problems = refused().problems
            problems.shouldNotBeEmpty()
            problems.forEach { withClue(it.message) { it.message.length shouldBeLessThan 500 } }
        }
    }

    test("what could command a terminal is shown as text") {
        val refused = json("\"arity\": \"\\u001b[2J\"")
        refused.problems.single().message shouldContain "'\\x1B[2J'"
        refused.message.orEmpty() shouldNotContain "\u001b"
    }

    test("a short value is shown whole") {
        xml("<parameter id=\"0\">Front</parameter>").message.orEmpty() shouldNotContain "…"
    }
})
