package argo.filters.matching

import argo.filters.Condition
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import argo.filters.format.XmlFilters
import argo.filters.jason.perceptText
import argo.filters.rule
import argo.filters.xml
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FreeSpec
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax

/** The percepts that a rule with [conditions] on `d` drops and keeps. */
private data class Case(val conditions: String, val drops: List<String>, val keeps: List<String>)

private fun parameter(operator: String, value: String, id: Int = 0) =
    "<parameter id='$id' operator='$operator'>${value.replace("&", "&amp;").replace("<", "&lt;")}</parameter>"

private fun filterOn(conditions: String) = "<filter><predicate>d</predicate>$conditions</filter>"

private fun decides(matcher: PerceptMatcher, percept: String, dropped: Boolean) = withClue(percept) {
    matcher.drops(percept) shouldBe dropped
    matcher.drops(perceptText(ASSyntax.parseLiteral(percept))) shouldBe dropped
}

class PerceptMatcherSpec : FreeSpec({
    "a rule without conditions meets every percept of its predicate and no other" {
        val matcher = rule("d")
        for (percept in listOf("d", "d(1)", "d(a,b,c)", " d ( 1 ) ", "d[x]", "d(1)[x,y(2)]", "default::d(1)", "d[]", "/* c */ d // c")) {
            decides(matcher, percept, true)
        }
        for (percept in listOf("~d", "~d(1)", "e", "dd", "d1(1)", "'d'", "house::d(1)", "dist(d)", "begin", "true")) {
            decides(matcher, percept, false)
        }
    }

    "an argument that is no value meets no condition, whatever the filter does with what it matches" {
        val conditions = "<parameter id='0'>front</parameter><parameter id='1' operator='NE'>3</parameter>"
        val keeping = XmlFilters.read("<PerceptionFilter keep='true'>${filterOn(conditions)}</PerceptionFilter>", "k.xml").matcher()
        for (percept in listOf("d(front,X)", "d(front,_)", "d(front,1+1)")) {
            decides(rule("d", conditions), percept, false)
            decides(keeping, percept, true)
        }
        // rules without a condition on the variable treat the percept as usual
        decides(rule("d"), "d(front,X)", true)
        decides(rule("d", "<parameter id='0'>front</parameter>"), "d(front,X)", true)
        decides(rule("d", "<parameter id='0'>front</parameter>"), "d(Side,1)", false)
    }

    "a predicate may be negated, quoted or in a namespace" {
        decides(rule("~open"), "~open(door)", true)
        decides(rule("~open"), "~ open(door)", true)
        decides(rule("~open"), "open(door)", false)
        decides(rule("'Left, wheel ('"), "'Left, wheel ('(1)", true)
        decides(rule("house::dist"), "house::dist(1)", true)
        decides(rule("house::dist"), "dist(1)", false)
        decides(rule("house::~dist"), "house::~dist(1)", true)
        decides(rule("default::dist"), "dist", true)
        decides(rule("true"), "true", true)
    }

    "conditions" - {
        listOf(
            Case(
                parameter("EQ", "36"),
                listOf("d(36)", "d(36.0)", "d(3.6e1)", "d( 36 , x)", "d(+36)", "d((36))"),
                listOf("d", "d(37)", "d(-36)", "d(\"36\")", "d('36')", "d(a,36)", "d([36])"),
            ),
            Case(
                parameter("EQ", "-0.5"),
                listOf("d(-0.5)", "d(- 0.5)", "d(-.5)", "d(-(0.5))", "d(-(+(.5)))"),
                listOf("d(0.5)", "d(-(-0.5))"),
            ),
            Case(parameter("EQ", "0"), listOf("d(0)", "d(-0)", "d(0.0)"), listOf("d(1)")),
            Case(
                parameter("NE", "front"),
                listOf("d(back)", "d(\"front\")", "d('front')", "d(1)", "d(front(1))", "d(front[x])", "d(~front)", "d([])"),
                listOf("d(front)", "d", "d((front))"),
            ),
            Case(parameter("EQ", "\"a,b\""), listOf("d(\"a,b\")"), listOf("d(a,b)", "d(\"a\",\"b\")", "d(\"a, b\")")),
            Case(parameter("EQ", "\"say \\\"hi\\\"; \\n )]\""), listOf("d(\"say \\\"hi\\\"; \\n )]\")"), listOf("d(\"say hi\")")),
            Case(parameter("EQ", "\"C:\\\\t\""), listOf("d(\"C:\\\\t\")"), listOf("d(\"C:\\t\")")),
            Case(
                parameter("EQ", "pos( 1, 2.0 )"),
                listOf("d(pos(1,2))", "d(pos(1.0, 2) )"),
                listOf("d(pos(1,3))", "d(pos(1))", "d(pos(1,2,3))", "d(1,2)", "d(~pos(1,2))", "d(pos(1,2)[a])"),
            ),
            Case(
                parameter("EQ", "[a,[b|[c]],\"]\"]"),
                listOf("d([a,[b,c],\"]\"])", "d([a|[[b,c],\"]\"]])"),
                listOf("d([a,b,c])", "d([])", "d([a,[b,c]])"),
            ),
            Case(
                parameter("EQ", "p[a,b(1)]"),
                listOf("d(p[a,b(1)])", "d(p[b(1),a])", "d(p[a,b(1),a])"),
                listOf("d(p)", "d(p[a])", "d(p[a,b(2)])"),
            ),
            Case(
                parameter("GT", "10"),
                listOf("d(11)", "d(10.001)", "d(1e3)"),
                listOf("d(10)", "d(9)", "d(-11)", "d(\"11\")", "d(eleven)", "d([11])", "d"),
            ),
            Case(parameter("GE", "10"), listOf("d(11)", "d(10)"), listOf("d(9.99)")),
            Case(parameter("LT", "10"), listOf("d(9)", "d(-11)", "d(-1e300)"), listOf("d(10)", "d(11)", "d(\"9\")")),
            Case(parameter("LE", "10"), listOf("d(10)", "d(9)"), listOf("d(10.5)")),
            Case(parameter("GT", "10") + parameter("LT", "20"), listOf("d(15)"), listOf("d(10)", "d(20)", "d(5)")),
            Case(
                parameter("EQ", "a") + parameter("EQ", "b", 1),
                listOf("d(a,b)", "d(a,b,c)"),
                listOf("d(a)", "d(a,c)", "d(c,b)", "d(b,a)"),
            ),
            Case("<parameter id='0'>a</parameter>", listOf("d(a)"), listOf("d(b)")),
            Case("<parameter id='0' operator='E'> a <!-- comment --></parameter>", listOf("d(a)"), listOf("d(b)")),
            Case("<parameter id='0' operator='ne'><![CDATA[a]]></parameter>", listOf("d(b)"), listOf("d(a)")),
            Case(parameter("B", "1"), listOf("d(2)"), listOf("d(1)")),
            Case(parameter("BE", "1"), listOf("d(1)"), listOf("d(0)")),
            Case(parameter("S", "1"), listOf("d(0)"), listOf("d(1)")),
            Case(parameter("SE", "1"), listOf("d(1)"), listOf("d(2)")),
            Case(
                parameter("IN", "[front, 1.0, \"a,b\", f(x), [y]]"),
                listOf("d(front)", "d(1)", "d(\"a,b\")", "d(f(x))", "d([y])"),
                listOf("d(back)", "d(2)", "d(f(y))", "d(y)", "d([front,1])", "d"),
            ),
            Case(parameter("IN", "front, back"), listOf("d(front)", "d(back)"), listOf("d(left)")),
            Case(
                parameter("MATCHES", "fr.*|[0-9]+"),
                listOf("d(front)", "d( fr )", "d(36.0)", "d(007)"),
                listOf("d(\"front\")", "d(a_front)", "d(36.5)", "d(-1)", "d(X)", "d"),
            ),
            Case(parameter("MATCHES", "\"(?i)hi.*\""), listOf("d(\"HI there\")", "d(\"hi\\n\\\"you\")"), listOf("d(hi)")),
            Case(parameter("MATCHES", "pos\\(1,.*\\)"), listOf("d(pos( 1 , 2 ))"), listOf("d(pos(2,1))")),
            Case("<annotation name='source' operator='MATCHES'>b.*</annotation>", listOf("d[source(bob)]"), listOf("d[source(alice)]")),
            Case(
                "<annotation name='q' operator='LT'>0.5</annotation>",
                listOf("d(f,3)[q(0.4),source(x)]", "d[source(x),q(0.1)]", "d[q(9),q(0)]"),
                listOf("d(f,3)[q(0.5)]", "d(f,3)", "d[q]", "d[r(0.4)]", "d[~q(0.4)]", "d(q(0.4))"),
            ),
            Case(
                "<anotation name='q'><limit operator='GT'>1</limit><limit operator='LT'>9</limit></anotation>",
                listOf("d[q(5)]"),
                listOf("d[q(1)]", "d[q(0),q(10)]"),
            ),
            Case("<anotation name='q' operator='GT'><limit>1</limit></anotation>", listOf("d[q(5)]"), listOf("d[q(1)]")),
            Case(
                "<anotation><name>q</name><limit operator='B'>2</limit></anotation>",
                listOf("d[q(3)]", "d[a,q(2.5)]"),
                listOf("d[q(2)]", "d[r(3)]", "d"),
            ),
            Case(
                "<anotation>\n <name> q </name>\n <limit>\n  <operator>S</operator>2</limit></anotation>",
                listOf("d[q(1)]"),
                listOf("d[q(2)]", "d"),
            ),
            Case("<parameter><id>1</id><operator>NE</operator>a</parameter>", listOf("d(x,b)"), listOf("d(x,a)", "d(b)")),
            Case("<annotation name='q'>a</annotation>", listOf("d[q(a)]", "d[q(a,b)]"), listOf("d[q(b,a)]", "d[q]", "d[q(\"a\")]")),
            Case("<annotation name='q' operator='NE'>a</annotation>", listOf("d[q(b)]"), listOf("d[q(a)]", "d[q]", "d", "d[r(b)]")),
            Case(
                "<annotation name='urgent'/>",
                listOf("d[urgent]", "d[a,urgent(1)]"),
                listOf("d", "d[~urgent]", "d[\"urgent\"]", "d(urgent)"),
            ),
        ).forEach { case ->
            case.conditions.let { it } - {
                "drops" { case.drops.forEach { decides(rule("d", case.conditions), it, true) } }
                "keeps" { case.keeps.forEach { decides(rule("d", case.conditions), it, false) } }
            }
        }
    }

    "a condition is false for an argument that is no plain ground term" {
        for (operator in listOf("EQ", "NE")) {
            val matcher = rule("d", parameter(operator, "front"))
            for (percept in listOf(
                "d(X)", "d(_)", "d(1+2)", "d(a & b)", "d(not a)", "d(X > 1)", "d({+!g})", "d(f(X))", "d([a|T])", "d([1*2])",
                "d(math.abs(-1))",
            )) {
                decides(matcher, percept, false)
            }
        }
    }

    "a rule with an arity meets percepts of that arity alone" {
        fun rule(arity: Int) = xml("<filter arity='$arity'><predicate>d</predicate></filter>").matcher()
        decides(rule(0), "d", true)
        decides(rule(0), "d[x(1)]", true)
        decides(rule(0), "d(1)", false)
        decides(rule(2), "d(1,f(2,3))", true)
        decides(rule(2), "d([1,2])", false)
        decides(rule(2), "d(1,2,3)", false)
    }

    "a filter that keeps drops everything that no rule meets" {
        val front = "<filter><predicate>dist</predicate>${parameter("EQ", "f")}</filter><filter><predicate>~open</predicate></filter>"
        val matcher = XmlFilters.read("<PerceptionFilter keep='true'>$front</PerceptionFilter>", "front.xml").matcher()
        for (percept in listOf("dist(f,3)", "~open(door)", " dist(f)[x]")) decides(matcher, percept, false)
        for (percept in listOf("dist(b,3)", "~dist(f,3)", "light(f,3)", "open(door)", "dist", "x::dist(f,3)", "true", "'dist'(f)")) {
            decides(matcher, percept, true)
        }
        for (text in listOf("not", "not(1)", "dist(f", "light(", "1", "", "true(1)")) matcher.drops(text) shouldBe false
    }

    "a percept may stand anywhere in a text" {
        val frame = "light(b,40);dist(f,123);dist(b,7);"
        val matcher = rule("dist", parameter("EQ", "f"))
        matcher.drops(frame, 12, 23) shouldBe true
        matcher.drops(frame, 24, 33) shouldBe false
        matcher.drops(frame, 0, 11) shouldBe false
        matcher.drops(frame, 12, 22) shouldBe false
    }

    "a pattern cannot stall the agent" {
        val matcher = rule("d", parameter("MATCHES", "\"(a|a|aa)*b\""))
        matcher.drops("d(\"" + "a".repeat(50_000) + "\")") shouldBe false
    }

    "a large filter decides as a small one" {
        val rules = (0 until 1_000).map { Rule("sensor$it", Condition.Argument(0, TermTest.Compare(Operator.LT, GroundTerm.of("$it")))) }
        val matcher = PerceptionFilter("large", rules).matcher()
        for (number in 0 until 1_000) {
            matcher.drops("sensor$number(${number - 1})") shouldBe true
            matcher.drops("sensor$number($number)") shouldBe false
        }
        matcher.drops("sensor1000(0)") shouldBe false
    }

    "two rules on one predicate both count" {
        val matcher = xml(
            "<filter><predicate>d</predicate>${parameter("EQ", "a")}</filter>" +
                "<filter><predicate>d</predicate>${parameter("EQ", "b")}</filter>",
        ).matcher()
        decides(matcher, "d(a)", true)
        decides(matcher, "d(b)", true)
        decides(matcher, "d(c)", false)
    }

    "a filter without rules keeps everything" { decides(xml("").matcher(), "d(1)", false) }
})
