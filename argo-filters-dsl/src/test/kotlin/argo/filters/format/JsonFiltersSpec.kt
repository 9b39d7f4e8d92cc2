package argo.filters.format

import argo.filters.Condition
import argo.filters.FilterException
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.filters
import argo.filters.rule
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FreeSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.PropertyTesting
import io.kotest.property.checkAll

private fun problems(document: String) = shouldThrow<FilterException> { JsonFilters.read(document, "f.json") }.problems

class JsonFiltersSpec : FreeSpec({
    "what is written is read back to an equal filter" {
        checkAll(2 * PropertyTesting.defaultIterationCount, filters) {
            JsonFilters.read(JsonFilters.write(it), "generated.json") shouldBe it
        }
    }

    "it is written for people too" {
        val filter = PerceptionFilter(
            "f", Rule("temperature"),
            Rule(
                "distance",
                Condition.Argument(0, TermTest.Compare(Operator.NE, GroundTerm.of("front"))),
                Condition.Annotation("q", TermTest.Compare(Operator.LT, GroundTerm.of("0.5"))),
            ),
        )
        JsonFilters.write(filter) shouldBe """
            {
              "rules": [
                {
                  "predicate": "temperature"
                },
                {
                  "predicate": "distance",
                  "conditions": [
                    {
                      "argument": 0,
                      "operator": "NE",
                      "value": "front"
                    },
                    {
                      "annotation": "q",
                      "operator": "LT",
                      "value": 0.5
                    }
                  ]
                }
              ]
            }
        """.trimIndent() + "\n"
    }

    "values are Jason's terms" {
        fun value(json: String): GroundTerm {
            val document = """{"rules": [{"predicate": "d", "conditions": [{"argument": 0, "value": $json}]}]}"""
            val condition = JsonFilters.read(document, "f.json").rules[0].conditions[0] as Condition.Argument
            return (condition.test as TermTest.Compare).value
        }
        value("36") shouldBe GroundTerm.of("36")
        value("-3.60e1") shouldBe GroundTerm.of("-36")
        value("\"36.0\"") shouldBe GroundTerm.of("36")
        value("\"front\"") shouldBe GroundTerm.of("front")
        value("\"\\\"front\\u00e9\\\"\"") shouldBe GroundTerm.Text("fronté")
        value("\"pos(1, [2])\"") shouldBe GroundTerm.of("pos(1,[2])")
    }

    "it is called as its file is, with a byte-order mark or without" {
        JsonFilters.read("\uFEFF{\"rules\": []}".toByteArray().inputStream(), "filters/near.json").name shouldBe "near"
    }

    "bytes that are not UTF-8 are refused where they stand" {
        val bytes = "{\n \"é".toByteArray(Charsets.ISO_8859_1)
        shouldThrow<FilterException> { JsonFilters.read(bytes.inputStream(), "f.json") }.message shouldContain "f.json:2:3: a byte"
    }

    "one problem, with its position" - {
        fun rule(members: String) = """{"rules": [{"predicate": "d", $members}]}"""
        fun smooth(members: String) = """{"rules": [], "smooth": [{"predicate": "d", "conditions": [{$members}]}]}"""
        fun condition(members: String) = rule(""""conditions": [{$members}]""")
        listOf(
            "¦[]" to "an array where a filter is expected",
            "¦\"x\"" to "'x' where a filter is expected",
            "¦{}" to "has no \"rules\"",
            "{\"rules\": ¦{}}" to "\"rules\" is an object; expected an array",
            "{\"rules\": [¦1]}" to "1 where a rule is expected",
            "{\"rules\": [],\n ¦\"rule\": []}" to "\"rule\" in a filter; expected rules or critical or smooth or keep or onSwitch",
            "{\"rules\": [], ¦\"rules\": []}" to "a second \"rules\"",
            "{\"rules\": [], \"keep\": ¦1}" to "\"keep\" is 1; expected true or false",
            "{\"rules\": [], \"keep\": ¦\"true\"}" to "\"keep\" is 'true'",
            "{\"rules\": [], \"onSwitch\": ¦\"stay\"}" to "expected forget or freeze",
            "{\"rules\": [¦{}]}" to "the rule has no \"predicate\"",
            "{\"rules\": [{\"predicate\": ¦\"\"}]}" to "'' is no functor",
            "{\"rules\": [{\"predicate\": ¦\"Dist\"}]}" to "'Dist' is no functor",
            "{\"rules\": [{\"predicate\": ¦1}]}" to "\"predicate\" is 1; expected text",
            rule("¦\"parameter\": 1") to "\"parameter\" in a rule",
            rule("\"arity\": ¦-1") to "\"arity\" is -1; expected a whole number from 0",
            rule("\"arity\": ¦\"1\"") to "\"arity\" is '1'",
            rule("\"everyMs\": ¦0") to "expected a whole number from 1",
            rule("\"everyMs\": ¦9223372036854775808") to "expected a whole number from 1",
            rule("\"arity\": ¦2147483648") to "expected a whole number from 0",
            rule("\"deadband\": ¦0") to "expected a finite number above 0",
            condition("¦").replace("{¦}", "¦{}") to "both or neither",
            condition("\"argument\": 0, \"annotation\": \"q\"").replace("{\"argument\"", "¦{\"argument\"") to "both or neither",
            condition("\"argument\": ¦1.5, \"value\": 1") to "\"argument\" is 1.5; expected a whole number from 0",
            condition("\"argument\": 0, \"operator\": ¦\"NEQ\", \"value\": 1") to "the operator 'NEQ'; expected EQ",
            condition("\"argument\": 0, \"operator\": ¦null, \"value\": 1") to "\"operator\" is null",
            condition("\"argument\": 0, \"operator\": \"GT\", \"value\": ¦\"front\"") to "'front' is not one",
            condition("\"argument\": 0, \"value\": ¦true") to "the value is true",
            condition("\"argument\": 0, \"value\": ¦[1]") to "the value is an array",
            condition("\"argument\": 0, \"value\": ¦\"Front\"") to "is a variable",
            condition("\"argument\": 0, \"operator\": \"IN\", \"value\": ¦[]") to "at least one value",
            condition("\"argument\": 0, \"operator\": \"IN\", \"value\": ¦[{}]") to "the value is an object",
            condition("\"argument\": 0, \"operator\": \"MATCHES\", \"value\": ¦\"(\"") to "not a regular expression",
            condition("\"argument\": 0").replace("{\"argument\"", "¦{\"argument\"") to "there is no \"value\"",
            condition("\"argument\": 0, ¦\"limits\": [], \"value\": 1") to "\"limits\" on an argument",
            condition("\"annotation\": \"q\", ¦\"deadband\": 1") to "\"deadband\" on an annotation",
            condition("\"annotation\": \"q\", ¦\"value\": 1, \"limits\": []") to "\"value\" on an annotation",
            condition("\"annotation\": \"q\", \"limits\": [¦{}]") to "there is no \"value\"",
            condition("\"argument\": 0, \"operator\": \"GT\", \"value\": 4, \"until\": ¦5") to "expected a number below that",
            condition("\"annotation\": \"q\", ¦\"until\": 1, \"value\": 1") to "\"until\" on an annotation",
            condition("\"argument\": 0, ¦\"median\": 3, \"value\": 1") to "\"median\" in a condition",
            smooth("\"argument\": 0, \"median\": ¦4") to "\"median\" is 4; expected an odd number of percepts from 3 to 99",
            smooth("\"argument\": 0, \"median\": 3, \"maxRate\": ¦-1") to "\"maxRate\" is -1; expected a finite number above 0",
            smooth("\"argument\": 0, \"outliers\": 3, \"among\": ¦\"5\"") to "\"among\" is '5'; expected an odd number",
            smooth("\"annotation\": \"q\", ¦\"median\": 3").replace("[{\"a", "[{\"argument\": 1, \"median\": 3}, {\"a") to
                "\"median\" on an annotation",
            rule("\"conditions\": [{\"argument\": 1, \"deadband\": 1}, {\"argument\": 1, ¦\"deadband\": 2}]") to "a second deadband",
        ).forEach { (marked, words) ->
            (marked.replace("\n", "⏎")) {
                val before = marked.substringBefore('¦')
                val found = problems(marked.replace("¦", ""))
                withClue(found) {
                    found shouldHaveSize 1
                    found.single().message shouldContain words
                    found.single().line shouldBe before.count { it == '\n' } + 1
                    found.single().column shouldBe before.length - before.lastIndexOf('\n')
                }
            }
        }
    }

    "all problems of a document are reported at once, in the order of the text" {
        val document = """
            {"onSwitch": 1,
             "rules": [{"predicate": "X", "arity": -1},
              {"conditions": [{"argument": 0, "operator": "?", "value": 1}]}],
             "x": 0}
        """.trimIndent()
        problems(document).map { it.line to it.column } shouldBe listOf(1 to 14, 2 to 26, 2 to 40, 3 to 3, 3 to 47, 4 to 2)
    }

    "text that is not JSON is refused with its position" {
        val refused = listOf(
            "" to (1 to 1),
            "{\"rules\": [}" to (1 to 12),
            "{\n  \"rules\" []}" to (2 to 11),
            "{\"rules\": [dist]}" to (1 to 16),
            "{\"rules\": []} x" to (1 to 16),
            "{\"rules\": [],}" to (1 to 14),
            "{\"rules\": [{\"predicate\":\n \"d\n\"}]}" to (2 to 4),
        )
        for ((document, position) in refused) {
            withClue(document) {
                val problem = problems(document).single()
                problem.message shouldContain "not JSON"
                (problem.line to problem.column) shouldBe position
            }
        }
    }

    "what is wrong is reported in plain words" - {
        fun nested(depth: Int) = "[".repeat(depth) + "]".repeat(depth)
        listOf(
            nested(40) to "arrays and objects nested more than 32 deep",
            "{\"rules\": [" to "it ends in the array that begins in line 1, column 11",
            "{\n {\n" to "expected a name in double quotes",
            "\n{\"rules\": [{\"predicate\": \"di" to "it ends in the object that begins in line 2, column 12",
            "{\"rules\": [}" to "in the array that begins in line 1, column 11",
            "{\"rules\": [1,]}" to "expected a value",
            "[" + "1".repeat(2_000) + "]" to "a number or a name that is too long",
            "{\"rules\" []}" to "expected a colon",
            "{\"rules\": [] 1}" to "expected a comma",
            "[tru]" to "'tru'",
            "// the front\n[]" to "it has a comment, and JSON has none",
            "[NaN]" to "NaN and infinity are no numbers of JSON",
            "[\"a\nb\"]" to "has to be escaped",
        ).forEach { (document, words) ->
            (document.take(40).replace("\n", "⏎")) {
                val message = problems(document).single().message
                message shouldContain words
                listOf("Source", "REDACTED", "Stream", "marker", "Object", "()", "ALLOW", "Feature").forEach { message shouldNotContain it }
            }
        }
    }

    "nesting without end does not use up the stack" {
        problems("[".repeat(50_000) + "]".repeat(50_000)) shouldHaveSize 1
        problems("{\"a\":".repeat(50_000) + "1" + "}".repeat(50_000)) shouldHaveSize 1
    }
})
