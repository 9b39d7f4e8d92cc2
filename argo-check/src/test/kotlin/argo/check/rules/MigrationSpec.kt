package argo.check.rules

import argo.check.findings.Level
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.useDirectoryEntries

/** Programs for other ARGO versions get findings where ARGO behaves differently. */
class MigrationSpec : FunSpec({
    val root = tempdir().toPath()
    fun findings(vararg files: Pair<String, String>) = findingsIn(root, *files).filter { it.rule !in OF_ANY_PROGRAM }

    fun of(line: String) = findings("a.asl" to line)

    context("without differences there are no advices") {
        listOf(
            "+!s : serialPort(P) <- .argo.port(P); .argo.limit(20); .argo.percepts(open).",
            "+!s <- .port(ttyACM0); .limit(50); .percepts(block); .act(front); .filter(none).",
            "+!s <- argo.port(\"/dev/ttyUSB0\", [baud(115200)]); argo.act(say(\"hi\")); argo.explain(d(1), W).",
            "+port(P,S) : S = off | S = timeout <- .argo.percepts(close).",
            "+port(ttyACM0,on)[source(percept)] <- .print(x). +!s <- .argo.port(ttyACM0).",
            "+!s <- .send(bob, tell, port(1,2,3)); .my.act(x); .wait(1000).",
            "+!s <- argo.limit(1000); argo.limit(2000).",
            "+!s : o(O) <- argo.port(P, O); argo.port(P, [baud(Rate), as(left), protocol(auto)]).",
            "+!s : o(T) <- argo.act(x, [urgent, timeout(T), port(P)]).",
            "-!s[error(no_such_port)] <- true. -!t[error(E)] <- true. -!u[error(no_relevant)] <- .fail(error(mine)).",
        ).forEach { line -> test(line) { of(line).shouldBeEmpty() } }
    }

    context("what must change is reported with the line") {
        listOf(
            "+!s <- .argo.port(ttyACM0, true)." to "the second argument of .argo.port is a list of options here, not true",
            "+!s <- .port(a, b, c)." to ".port has 3 arguments",
            "+!s <- .port()." to "here should be a term, not )",
            "+!s <- .port(/dev/ttyACM0)." to "here should be a term, not /",
            "+!s <- .argo.limit(1000000000)." to ".argo.limit(1000000000) is in milliseconds: one perception in 16667 minutes",
            "+!s <- .limit(0.5)." to "is a whole number of milliseconds from 0, not 0.5",
            "+!s <- .limit(-1)." to "is a whole number of milliseconds from 0, not -1",
            "+!s <- argo.limit(\"fast\")." to "the interval of argo.limit is a number of milliseconds, not \"fast\"",
            "+!s <- argo.change_filter([a])." to "argo.change_filter takes one name",
            "+!s <- argo.change_filter(3)." to "argo.change_filter takes one name",
            "+!s <- .percepts(opened)." to "perception is set to open, block or close, not opened",
            "+!s <- .act(move, 3)." to ".act has 2 arguments",
            "+!s <- .argo.filter(only, led(X), X = on)." to ".argo.filter(only, …) is a filter written into the plan",
            "+!s <- .argo.filter(remove)." to ".argo.filter(remove) is a filter written into the plan",
            "+!s <- .argo.sleep(3)." to "there is no internal action .argo.sleep",
            "+!s <- argo.filter(x)." to "there is no internal action argo.filter",
            "+!s <- argo.Limit(50)." to "there is no internal action argo.Limit",
            "+!s <- .Port(ttyACM0)." to "there is no internal action .Port",
            "+!s <- .argo.Percepts(open)." to "there is no internal action .argo.Percepts",
            "+!s <- Argo.act(front)." to "here should be a full stop, not .act",
            "+!s <- argo.port(P, [bawd(1)])." to "bawd is no option of argo.port",
            "+!s <- argo.port(P, [baud(115200), timeout(0)])." to "timeout of argo.port is a whole number from 1 to 600000, not 0",
            "+!s <- argo.port(P, [mode(sing)])." to "mode of argo.port is request or listen, not sing",
            "+!s <- argo.port(P, [baud])." to "baud of argo.port needs a value",
            "+!s <- argo.ports([a, port(b, [az(right)])])." to "az is no option of a port",
            "+!s <- argo.port(a, [baud(9600), baud(115200)])." to "baud of argo.port is given twice",
            "+!s <- argo.act(stop, [urgent, urgent])." to "urgent of argo.act is given twice",
            "+!s <- argo.act(stop, [urgnt])." to "urgnt is no option of argo.act",
            "+!s <- argo.act(stop, [timeout(-5)])." to "timeout of argo.act is a whole number from 1 to 600000, not -5",
            "+!s <- argo.act(stop, [latest(1)])." to "latest of argo.act has no value, and here it is 1",
            "+port(P,S)[source(interoception)] <- true." to "no belief has source(interoception) here",
            "+port(P,broken) <- true." to "a port is never broken",
            "+port(ttyUSB0,on) <- true. +!s <- .port(\"/dev/ttyUSB0\")." to "so that ttyUSB0 never matches",
        ).forEach { (line, what) ->
            test(line) {
                val found = findings("a.asl" to "// an agent\n\n$line\n").filter { it.level == Level.ERROR }
                withClue(found) {
                    found shouldHaveSize 1
                    found.single().what shouldContain what
                    found.single().place.begin.line shouldBe 3
                    found.single().place.file.name shouldBe "a.asl"
                }
            }
        }
    }

    test("an action whose name is nearly right is guessed") {
        of("+!s <- argo.expain(d(1), W).").single().remedy shouldBe "did you mean argo.explain?"
        of("+!s <- argo.Limit(50).").single().remedy shouldBe "did you mean argo.limit?"
        of("+!s <- argo.sleep(3).").single().remedy shouldStartWith "the actions are argo.port"
    }

    context("what may matter is a note") {
        listOf(
            "+!s <- argo.port(\"COM5\", [as(Left)])." to "Left is a variable to Jason",
            "+!s <- .port(COM5)." to "COM5 is a variable to Jason",
            "+!s <- .argo.limit(50); .argo.limit(1000); .argo.limit(2000)." to "one perception in 1000 ms",
            "+!s <- .act(\"led\")." to "the string \"led\" is sent without its quotes here",
            "+!s <- .port(ttyACM0); .port(ttyACM1)." to "ttyACM1 is another port than ttyACM0 before",
            "+!s <- .change_filter(byValue)." to "the project has no file of the filter byValue",
        ).forEach { (line, what) ->
            test(line) {
                of(line).single().level shouldBe Level.HINT
                of(line).single().what shouldContain what
            }
        }
    }

    test("a wrong or missing architecture in a project file is reported") {
        val found = findings(
            "old.mas2j" to "MAS old {\n infrastructure: Centralised\n agents:\n  bob agentArchClass jason.Argo;\n  eve ./x/talker.asl;\n" +
                "  max;\n aslSourcePath: \"src\";\n}",
            "src/bob.asl" to "+!s <- .port(a).", "src/talker.asl" to "+!s <- .act(a).", "src/max.asl" to "+!s <- .filter(none).",
        )
        found.map { it.place.begin.line to it.level } shouldBe listOf(2 to Level.HINT, 4 to Level.ERROR, 5 to Level.ERROR)
        found[1].what shouldContain "jason.Argo belongs to another version"
        found[2].what shouldContain "agent eve calls internal actions of ARGO"
        findings("new.mas2j" to "MAS m { agents: bob agentArchClass argo.Arch; }", "bob.asl" to "+!s <- .port(a).").shouldBeEmpty()
    }

    test("an unknown infrastructure is noted, since Jason ignores it; a fleet is known, and its option needs no architecture") {
        val unknown = findings("a.mas2j" to "MAS a { infrastructure: Fleets(hosts([b])) agents: a at \"b\"; }", "a.asl" to "")
        unknown.single().run {
            level shouldBe Level.WARNING
            what shouldBe "neither Jason nor ARGO has an infrastructure Fleets"
            remedy shouldBe "did you mean Fleet?"
        }
        val fleet = "MAS a { infrastructure: Fleet(hosts([b])) agents: a [argo_fleet=\"agents\"] at \"b\"; }"
        findings("a.mas2j" to fleet, "a.asl" to "").shouldBeEmpty()
    }

    test("the architecture in the wrong case is found, since Java tells upper from lower case") {
        val advice = findings("new.mas2j" to "MAS m { agents: bob agentArchClass argo.arch; }").single()
        advice.level shouldBe Level.ERROR
        advice.what shouldContain "there is no class argo.arch"
        advice.remedy shouldBe "argo.Arch"
        findings("p.jcm" to "mas m { agent b { ag-arch: Argo.Arch } }").single().what shouldContain "there is no class Argo.Arch"
    }

    test("another class in the package of ARGO is noted, since it may be a slip, or one of the project") {
        val advice = findings("new.mas2j" to "MAS m { agents: bob agentArchClass argo.Arc; }").single()
        advice.level shouldBe Level.HINT
        advice.what shouldBe "ARGO has no class argo.Arc; the project may have one"
        findings("new.mas2j" to "MAS m { agents: bob agentArchClass robots.Arc; }").shouldBeEmpty()
    }

    test("options of the architecture that it does not have, or not with this value, are reported") {
        fun of(options: String) = findings("new.mas2j" to "MAS m { agents: bob [$options] agentArchClass argo.Arch; }")
        of("argo_sensng=every").single().run { level to remedy } shouldBe (Level.ERROR to "did you mean argo_sensing?")
        of("argo_percepts=abc").single().what shouldBe "argo_percepts of argo.Arch is a whole number from 1 to 2147483647, not abc"
        of("argo_percepts=-3").single().what shouldContain "a number without a sign"
        of("argo_safe=\"f(X)\"").single().what shouldBe
            "argo_safe of argo.Arch is a command without variables, as stop or \"speed(0)\", not f(X)"
        of("argo_safe=\"say(\\\"X\\\",1)\"").shouldBeEmpty()
        of("argo_view=99999999").single().what shouldBe "argo_view of argo.Arch is a whole number from 0 to 65535, not 99999999"
        of("argo_sensing=never").single().what shouldBe "argo_sensing of argo.Arch is fresh or every or in_cycle, not never"
        of("argo_diary=on").single().level shouldBe Level.HINT
        of("verbose=2, argo_sensing=every, argo_view=8080, argo_record=\"last(5)\", argo_ros=\"robot:9090\"").shouldBeEmpty()
        of("argo_resume=\"bob.state\"").shouldBeEmpty()
        of("argo_view=8080, argo_view=8081").single().what shouldBe "argo_view is given twice"
        of("argo_fleet=\"computers, agents\"").shouldBeEmpty()
        of("argo_fleet=robots").single().what shouldBe
            "argo_fleet of argo.Arch is computers and agents, or one of them, as \"computers,agents\", not robots"
        of("argo_ros=9090").single().what shouldBe
            "argo_ros of argo.Arch is the address of a rosbridge_server, as \"robot:9090\", not 9090"
        of("argo_ros=\"\"").single().what shouldContain "not "
        of("argo_resume=\" \"").single().what shouldContain "argo_resume of argo.Arch is the name of a file, as \"robot.state\", not "
        of("argo_record=\"last(0)\"").single().what shouldContain "not last(0)"
    }

    test("NE is noted where a program may be for another version, and what has no effect everywhere") {
        val rule = "<filter><predicate>d</predicate><parameter operator=\"NE\" id=\"0\">f</parameter></filter>"
        fun of(agent: String, rules: String) =
            findings("a.asl" to agent, "filters/front.xml" to "<PerceptionFilter>$rules</PerceptionFilter>").map { it.what }
        of("+!s <- argo.change_filter(front).", rule).shouldBeEmpty()
        of("+!s <- .change_filter(front).", rule).single() shouldStartWith "NE means differs"
        of("+!s <- argo.change_filter(front).", rule + rule).single() shouldStartWith "rule 2 (d where argument 0 is not f) has no effect"
    }

    test("projects of JaCaMo and Gradle that bring another version are found") {
        val found = findings(
            "p.jcm" to "mas hello {\n agent bob: a.asl {\n  ag-arch: jason.Argo\n }\n" +
                " uses package: argo \"com.github.chon-group:argo-jcm:1.1\"\n}",
            "build.gradle" to "// com.github.chon-group:Argo\nimplementation 'com.github.chon-group:Argo:1.0'",
        )
        found.map { it.place.begin.line } shouldContainExactly listOf(2, 3, 5)
        val other = "mas m { agent b { ag-arch: argo.Arch } uses package: mailer \"com.github.chon-group:mailer:1\" }"
        findings("p.jcm" to other).shouldBeEmpty()
    }

    test("filter files are read, those that an agent changes to and those that are given") {
        val found = findings(
            "a.asl" to "+!s <- .change_filter(front).",
            "filters/front.xml" to "<PerceptionFilter>\n<filter><predicate>d</predicate>\n" +
                "<parameter operator=\"NE\" id=\"0\">f</parameter></filter>\n" +
                "<filter><predicate>d</predicate><anotation name=\"q\" operator=\"E\">fr.*</anotation></filter></PerceptionFilter>",
            "other.xml" to "<project/>",
        )
        val refused = found.single { it.level == Level.ERROR }
        refused.what shouldContain "for a regular expression the operator is MATCHES"
        "${refused.place}" shouldContain "front.xml:4:"
        found.filter { it.level == Level.HINT }.map { it.place.begin.line } shouldContainExactly listOf(3)
    }

    test("filters that the project makes in Kotlin, or has as JSON, are there") {
        val agent = "+!s <- .change_filter(front); .change_filter(byDay); .change_filter(\"night.json\")."
        val source = "val f = keepFilter(\n  \"front\") { }"
        val project = arrayOf("src/agt/a.asl" to agent, "src/main/kotlin/F.kt" to source,
            "src/agt/filters/night.json" to "{\"rules\": [{\"predicate\": \"dist\"}]}")
        findings(*project).single().what shouldContain "the project has no file of the filter byDay"
        findings(*project, "src/agt/byDay.json" to "{\"rules\": [{\"predicate\": \"dist\"}]}").shouldBeEmpty()
        findings(*project, "build/F.kt" to "dropFilter(\"byDay\") { }").single().what shouldContain "byDay"
    }

    test("the actions that are known are those there are") {
        val sources = Path.of("../argo-arch/src/main/kotlin/argo")
        val actions = sources.useDirectoryEntries("*.kt") { files ->
            files.map { it.name.removeSuffix(".kt") to it.readText() }
                .filter { (name, text) -> name[0].isLowerCase() && "open class $name " in text }.map { it.first }.toSet()
        }
        ArgoActions.NAMES shouldBe actions
        fun options(file: String) = Regex("\"([a-z]+)\"(?: ->| && literal.arity)").findAll(sources.resolve(file).readText())
            .map { it.groupValues[1] }.toSet()
        KnownOption.OF_PORT.keys shouldBe options("connecting/PortOptions.kt")
        KnownOption.OF_ACT.keys shouldBe options("acting/CommandOptions.kt")
        ArgoActions.ERRORS shouldBe Regex("^\\| `(\\w+)`", RegexOption.MULTILINE).findAll(Path.of("../docs/errors.md").readText())
            .map { it.groupValues[1] }.toSet()
        val architecture = listOf("ArchOptions.kt", "Resuming.kt", "perception/PerceptLimit.kt", "watching/ProgramWatchProvider.kt")
            .joinToString { sources.resolve(it).readText() }
        val archOptions = Regex("\"(argo_[a-z]+)\"").findAll(architecture).map { it.groupValues[1] }.toSet()
        KnownOption.OF_ARCH.keys - KnownOption.OF_FLEET shouldBe archOptions
        val dotForms = Path.of("../argo-arch/src/stdlib/kotlin/jason/stdlib/DotForms.kt").readText()
        ArgoActions.DOT_NAMES shouldBe Regex("^class (\\w+)", RegexOption.MULTILINE).findAll(dotForms).map { it.groupValues[1] }.toSet()
    }
})

/** Other findings that these program fragments cause. */
private val OF_ANY_PROGRAM = setOf("goal-without-plan", "plan-without-cause", "variable-once", "no-program")
