package samples.documents

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import java.nio.file.Path

/** Every command for readers of a page exists with its options. */
class CommandsSpec : FunSpec({
    val root = Path.of("..").toRealPath()
    val commands = Document.all(root).associateWith(ToldCommand::of)
    val check = CommandCheck(root)

    test("commands are found between fences, in sentences and in tables") {
        val told = commands.values.flatten().map { it.text }
        listOf("./argo new my-robot", "mvn -q compile exec:exec", "./argo bench latency", "java -jar lib/argo.jar ports --probe").forEach {
            told shouldContain it
        }
    }

    test("a command that does not exist is noticed") {
        val wrong = listOf(
            "./argo fly", "./argo demo --fly", "./argo demo --limit far", "./argo sample fly", "./argo experiment --fly",
            "./argo bench fly", "./argo jar fly", "./argo tools fly", "./argo new a b", "java -jar argo.jar ports --fly",
            "java -jar argo.jar request ttyACM0", "java -Xfly -jar argo.jar ports", "java -jar agro.jar", "java -cp lib/* no.such.Program",
            "mvn fly", "mvn fly:fly", "mvn -pl fly test", "mvn -Dtest=FlySpec test",
            "gradle fly", "gradle -Dfly=true", "./gradlew :fly:run", "./gradlew :samples:run --args=fly", "make fly", "./check --fly",
            "fly",
        )
        wrong.forEach { withClue(it) { check.problem(it.split(" ")) shouldNotBe null } }
    }

    test("./argo says of each command of the tools that it is one of them") {
        (check.tools - check.verbs).forEach { tool ->
            val said = ProcessBuilder("$root/argo", tool).start().errorReader().use { it.readText() }
            said shouldBe "./argo: there is no command '$tool', but a tool: ./argo tools $tool\n"
        }
    }

    context("there is what is told in") {
        commands.filterValues { it.isNotEmpty() }.forEach { (document, told) ->
            test("$document") {
                told.filter { NOT_TRIED.keys.none(it.text::startsWith) }.forEach { command ->
                    withClue(command) {
                        if (command.words[0] == "cd") folder(command, told) else check.problem(command.words) shouldBe null
                    }
                }
            }
        }
    }

    test("what is not tried is still told somewhere") {
        NOT_TRIED.keys.filterNot { start -> commands.values.flatten().any { it.text.startsWith(start) } }.shouldBeEmpty()
    }
})

/** The beginnings of commands that no test runs, with the reasons. */
private val NOT_TRIED = mapOf(
    "sudo usermod" to "changes the machine",
    "sudo apt" to "changes the machine",
    "lsusb" to "is the system's",
    "ssh" to "needs another computer",
    "rostopic" to "is a tool of ROS; RosCoreSpec runs it",
    "rosservice" to "is a tool of ROS; RosCoreSpec runs it",
    "./split " to "is run by javino-arduino/check",
    "cc " to "is run by FirmwareSnippetsSpec",
    "riscv64-unknown-elf-gcc" to "is for a microcontroller of the reader's; the Makefile's rules are the same",
    "sdcc " to "is run by javino-arduino/check",
    "qemu-system-riscv32" to "runs the reader's own program",
    "./board " to "needs a board; javino-arduino/tests/e2e/posix.py runs it on a pseudo-terminal",
)

/** Checks that a command that enters a folder follows a command that makes it. */
private fun folder(command: ToldCommand, told: List<ToldCommand>) {
    told.takeWhile { it !== command }.map { it.text } shouldContain "./argo new ${command.words[1]}"
}
