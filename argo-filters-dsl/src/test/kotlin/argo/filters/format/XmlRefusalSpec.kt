package argo.filters.format

import argo.filters.FilterException
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FreeSpec
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private fun problems(document: String) = shouldThrow<FilterException> { XmlFilters.read(document, "f.xml") }.problems

/** A refused rule: its [text], in which `¦` marks the beginning of the fault, and words of the message. */
private data class Refusal(val text: String, val words: String)

private fun inRule(elements: String, words: String) = Refusal("<filter><predicate>d</predicate>$elements</filter>", words)

private fun inSmoothing(elements: String, words: String) = Refusal("<smooth><predicate>d</predicate>$elements</smooth>", words)

class XmlRefusalSpec : FreeSpec({
    "one problem, with its position" - {
        listOf(
            inRule("<parameter id='0' ¦operator='NEQ'>1</parameter>", "the operator 'NEQ'; expected EQ, NE, GT"),
            inRule("<parameter ¦operator='' id='0'>1</parameter>", "the operator ''"),
            inRule("<parameter ¦operator='Ne' id='0'>1</parameter>", "the operator 'Ne'"),
            Refusal("¦<filter></filter>", "no predicate"),
            Refusal("¦<filter/>", "no predicate"),
            Refusal("<filter>¦<predicate/></filter>", "the predicate is empty"),
            Refusal("<filter>¦<predicate> \n </predicate></filter>", "the predicate is empty"),
            Refusal("<filter><predicate>¦Dist</predicate></filter>", "'Dist' is no functor"),
            Refusal("<filter><predicate> ¦dist(X)</predicate></filter>", "only the functor is expected"),
            Refusal("<filter><predicate>¦not</predicate></filter>", "'not' is no functor"),
            Refusal("<filter><predicate>¦~~a</predicate></filter>", "'~a' is no functor"),
            inRule("\n¦<predicate>e</predicate>", "a second predicate in one rule"),
            inRule("¦<parameter>1</parameter>", "has no id"),
            inRule("<parameter ¦id='-1'>1</parameter>", "the id '-1'"),
            inRule("<parameter ¦id='1.0'>1</parameter>", "the id '1.0'"),
            inRule("<parameter ¦id='first'>1</parameter>", "the id 'first'"),
            inRule("<parameter ¦id=''>1</parameter>", "the id ''"),
            inRule("<parameter ¦id='٣'>1</parameter>", "the id '٣'"),
            inRule("<parameter ¦id='99999999999'>1</parameter>", "the id '99999999999'"),
            inRule("¦<parameter id='0'/>", "the <parameter> is empty"),
            inRule("<parameter id='0'>¦Front</parameter>", "'Front' is a variable to Jason"),
            inRule("<parameter id='0'>¦front left</parameter>", "not a value that Jason can read"),
            inRule("<parameter id='0'>¦pos(1,X)</parameter>", "not a value that Jason can read"),
            inRule("<parameter id='0'>¦\"open</parameter>", "not a value that Jason can read"),
            inRule("¦<params/>", "the element <params> in <filter>; expected <predicate> or <parameter>"),
            inRule("¦<xi:include xmlns:xi='http://www.w3.org/2001/XInclude' href='x'/>", "the element <xi:include>"),
            Refusal("<filter><predicate>d¦<b/></predicate></filter>", "the element <b> in <predicate>"),
            Refusal("¦<rule/>", "the element <rule> in <PerceptionFilter>; expected <filter>"),
            Refusal("<filter ¦name='x'><predicate>d</predicate></filter>", "the attribute 'name' on <filter>; expected"),
            Refusal("<filter><predicate ¦id='0'>d</predicate></filter>", "the attribute 'id' on <predicate>; expected no attribute"),
            inRule("<parameter id='0'\n   ¦op=\"a'>b\">1</parameter>", "the attribute 'op' on <parameter>; expected id or operator"),
            Refusal("<filter xmlns:x='u'><predicate>d</predicate></filter>".replace("xmlns", "¦xmlns"), "the attribute 'xmlns:x'"),
            Refusal("¦stray<filter><predicate>d</predicate></filter>", "the text 'stray' in <PerceptionFilter>"),
            inRule("<!-- c -->\r\n ¦stray", "the text 'stray' in <filter>"),
            inRule(
                "<parameter id='0' operator='LT' ¦until='3'>4</parameter>",
                "the condition holds until 3 though it is less than 4; expected a number above that",
            ),
            inRule("<parameter id='0' operator='EQ' ¦until='5'>4</parameter>", "has no limit that 5 could be the second one of"),
            inRule("<parameter id='0' operator='LT' ¦until='x'>4</parameter>", "the until 'x'; expected a number, the second limit"),
            inRule("<parameter id='0' ¦median='3'>4</parameter>", "the attribute 'median' on <parameter>"),
            Refusal("¦<smooth><predicate>d</predicate></smooth>", "the rule smooths no argument; expected maxRate or outliers"),
            Refusal("<smooth ¦everyMs='5'><predicate>d</predicate><parameter id='1' median='3'/></smooth>", "the attribute 'everyMs'"),
            inSmoothing("<parameter id='1' ¦median='4'/>", "the median '4'; expected an odd number of percepts from 3 to 99"),
            inSmoothing("<parameter id='1' ¦maxRate='0'/>", "expected a finite number above 0, by which the argument can change"),
            inSmoothing("<parameter id='1' ¦outliers='0'/>", "expected a number of deviations from 1"),
            inSmoothing("<parameter id='1' median='3' ¦among='5'/>", "\"among\" without \"outliers\""),
            inSmoothing("<parameter id='1' median='3'/><parameter ¦id='2' median='3'/>", "a second argument that is smoothed"),
            inSmoothing("<parameter id='0' ¦deadband='3'>4</parameter><parameter id='1' median='3'/>", "the attribute 'deadband'"),
            inRule("¦<annotation>1</annotation>", "has no name"),
            inRule("<anotation><name> ¦Acc</name>1</anotation>", "'Acc' is no functor"),
            inRule("<anotation>¦<name/>1</anotation>", "the annotation's name is empty"),
            inRule("<anotation name='q'><name>¦q</name>1</anotation>", "a second 'name' on <anotation>"),
            inRule("<parameter><operator>¦NEQ</operator><id>0</id>1</parameter>", "the operator 'NEQ'"),
            Refusal("<filter><name>¦x</name><predicate>d</predicate></filter>", "the attribute 'name' on <filter>"),
            inRule("<annotation ¦name=''>1</annotation>", "the annotation's name is empty"),
            inRule("¦<annotation name='q' operator='EQ'/>", "the <annotation> is empty"),
            inRule("<anotation name='q'>¦<limit operator='GT'/></anotation>", "the <limit> is empty"),
            inRule("<anotation name='q' operator='GT'><limit ¦operator='LT'>1</limit></anotation>", "a second operator"),
            inRule("<annotation name='q'>¦5<limit operator='LT'>1</limit></annotation>", "the text '5' in <annotation>"),
            Refusal("<filter ¦arity='-1'><predicate>d</predicate></filter>", "arity=\"-1\"; expected a whole number from 0"),
            Refusal("<filter ¦everyMs='0'><predicate>d</predicate></filter>", "everyMs=\"0\"; expected a whole number from 1"),
            Refusal("<filter ¦everyMs='9223372036854775808'><predicate>d</predicate></filter>", "expected a whole number from 1"),
            Refusal("<filter ¦arity='2147483648'><predicate>d</predicate></filter>", "expected a whole number from 0"),
            Refusal("<filter ¦everyMs='1.5'><predicate>d</predicate></filter>", "everyMs=\"1.5\""),
            Refusal("<filter ¦deadband='0'><predicate>d</predicate></filter>", "the deadband '0'; expected a finite number above 0"),
            inRule("<parameter id='1' ¦deadband='wide'/>", "the deadband 'wide'"),
            inRule("<parameter id='1' deadband='1'/><parameter id='1' ¦deadband='2'/>", "a second deadband"),
            inRule("¦<parameter deadband='1'/>", "has no id"),
            inRule("¦<parameter id='1' operator='EQ' deadband='1'/>", "the <parameter> is empty"),
            inRule("<parameter id='0' operator='MATCHES'>¦(a</parameter>", "'(a' is not a regular expression"),
            inRule("<parameter id='0' operator='MATCHES'>¦(?=a)</parameter>", "is not a regular expression in RE2's syntax"),
            inRule("<parameter id='0' operator='MATCHES'>¦((a{100}){100}){100}</parameter>", "repeat more than"),
            inRule("<parameter id='0' operator='E'>¦fr.*</parameter>", "for a regular expression the operator is MATCHES"),
            inRule("<parameter id='0' operator='IN'>¦[]</parameter>", "IN needs at least one value"),
            inRule("<parameter id='0' operator='IN'>¦front back</parameter>", "is not a list of values"),
            inRule("<annotation name='q'><limit ¦id='0'>1</limit></annotation>", "the attribute 'id' on <limit>"),
        ).forEach { refusal ->
            (refusal.text.replace("\n", "⏎").replace("\r", "")) {
                val marked = "<?xml version='1.0'?>\n<!-- < > -->\n<PerceptionFilter>\n  ${refusal.text}\n</PerceptionFilter>"
                val before = marked.substringBefore('¦')
                val found = problems(marked.replace("¦", ""))
                withClue(found) {
                    found shouldHaveSize 1
                    found.single().message shouldContain refusal.words
                    found.single().line shouldBe before.count { it == '\n' } + 1
                    found.single().column shouldBe before.length - before.lastIndexOf('\n')
                }
            }
        }
    }

    "a comparison with something that is not a number" - {
        for (operator in listOf("GT", "GE", "LT", "LE", "B", "BE", "S", "SE")) {
            for (value in listOf("front", "\"36\"", "[1]", "f(1)")) {
                "$operator $value" {
                    val parameter = "<parameter id='0' operator='$operator'>$value</parameter>"
                    val found = problems("<PerceptionFilter><filter><predicate>d</predicate>$parameter</filter></PerceptionFilter>")
                    found.single().message shouldContain "is not one"
                    found.single().column shouldBe 81 + operator.length
                }
            }
        }
    }

    "words on the root that it does not know" {
        problems("<PerceptionFilter keep='yes'/>").single().toString() shouldBe "f.xml:1:19: keep=\"yes\"; expected true or false"
        problems("<PerceptionFilter onSwitch='Freeze'/>").single().message shouldBe "onSwitch=\"Freeze\"; expected forget or freeze"
    }

    "a wrong root" - {
        "is named" {
            problems("<PerceptionFilters/>").single().toString() shouldBe
                "f.xml:1:1: the root element is <PerceptionFilters>; expected <PerceptionFilter>"
        }
        "with a default namespace is not what is expected" {
            problems("<PerceptionFilter xmlns='urn:x'/>").single().message shouldContain "the attribute 'xmlns'"
        }
    }

    "all problems of a file are reported at once, in the order of the text" {
        val document = """
            <PerceptionFilter onSwitch="never">
              <filter>
                <parameter id="x" operator="NE">Front</parameter>
              </filter>
              <filtr/>
              <filter><predicate>a</predicate><parameter operator="GT" id="0">big</parameter></filter>
            </PerceptionFilter
        """.trimIndent()
        val refused = shouldThrow<FilterException> { XmlFilters.read(document, "f.xml") }
        refused.problems.map { it.line to it.column } shouldBe listOf(1 to 19, 2 to 3, 3 to 16, 3 to 37, 5 to 3, 6 to 67, 7 to 19)
        refused.message!!.lines() shouldBe refused.problems.map { "f.xml:${it.line}:${it.column}: ${it.message}" }
    }

    "text that is not well-formed XML is refused where it goes wrong" - {
        listOf(
            "" to (1 to 1),
            "hello" to (1 to 1),
            "<PerceptionFilter>\n<filter>" to (2 to 9),
            "<PerceptionFilter>\n</filter></PerceptionFilter>" to (2 to 3),
            "<PerceptionFilter/><PerceptionFilter/>" to (1 to 21),
            "<PerceptionFilter><filter><predicate>a</predicate><parameter id='0' id='1'>a</parameter></filter></PerceptionFilter>" to
                (1 to 75),
            "<PerceptionFilter>\n&unknown;</PerceptionFilter>" to (2 to 10),
            "<PerceptionFilter>\n\u0001</PerceptionFilter>" to (2 to 1),
        ).forEach { (document, position) ->
            "«${document.replace("\n", "⏎").replace("\u0001", "\\u0001")}»" {
                val found = problems(document)
                withClue(found) {
                    found.last().message shouldContain "not well-formed"
                    (found.last().line to found.last().column) shouldBe position
                }
            }
        }
        "with the remedy for an empty text, and for a declaration behind a blank line" {
            problems("\n").single().message shouldBe "the text is not well-formed XML: it is empty"
            problems("\n<?xml version='1.0'?><PerceptionFilter/>").single().message shouldBe
                "the text is not well-formed XML: <?xml …?> stands only at the very beginning; remove what is in front of it"
        }
        "without further problems that only come of the break" {
            problems("<PerceptionFilter><filter><predicate>a") shouldHaveSize 1
            problems("<PerceptionFilter><filter><predicate>a</predicate><parameter id='0'>") shouldHaveSize 1
            problems("<PerceptionFilter><filter>") shouldHaveSize 1
        }
    }

    "a document type declaration" - {
        val laughs = "<!DOCTYPE x [<!ENTITY a0 'ha'>" + (1..30).joinToString("") { "<!ENTITY a$it '&a${it - 1};&a${it - 1};'>" } + "]>"
        listOf(
            "<!DOCTYPE PerceptionFilter><PerceptionFilter/>",
            "<!DOCTYPE x SYSTEM 'file:///etc/passwd'><x/>",
            "<!DOCTYPE x [<!ENTITY e SYSTEM 'file:///etc/passwd'>]>" +
                "<PerceptionFilter><filter><predicate>&e;</predicate></filter></PerceptionFilter>",
            "<!DOCTYPE x [<!ENTITY % p SYSTEM 'http://localhost:1/'>%p;]><PerceptionFilter/>",
            "$laughs<PerceptionFilter>&a30;</PerceptionFilter>",
            "<!DOCTYPE x [<!ATTLIST filter operator CDATA '&lol;'>]><PerceptionFilter/>",
        ).forEachIndexed { number, document ->
            "is refused and nothing in it is used ($number)" {
                val problem = problems("\n <!-- <!DOCTYPE no> -->$document").single()
                problem.message shouldContain "document type declaration"
                (problem.line to problem.column) shouldBe (2 to 24)
            }
        }
    }

    "positions are right in a large file, after line ends of all kinds and characters of all widths" {
        val rule = "<filter>\r\n <predicate>d</predicate>\n <parameter id='0' operator='NE'>\"é漢\uD83D\uDE00&amp;\"</parameter>\r</filter>"
        val problem = problems("<PerceptionFilter>" + rule.repeat(5_000) + "\n  <wrong/></PerceptionFilter>").single()
        (problem.line to problem.column) shouldBe (3 * 5_000 + 2 to 3)
    }

    "unknown elements nested without end do not use up the stack" {
        val depth = 20_000
        val found = problems("<PerceptionFilter>" + "<x>".repeat(depth) + "</x>".repeat(depth) + "</PerceptionFilter>")
        found.first().message shouldContain "the element <x> in <PerceptionFilter>" // newer parsers also report their limit
    }
})
