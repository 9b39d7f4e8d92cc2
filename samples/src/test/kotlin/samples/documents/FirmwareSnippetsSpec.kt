package samples.documents

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.ints.shouldBeExactly
import java.io.File
import java.nio.file.Path

/** Compiles the sketches and the C code of pages against the board's library, with all warnings as errors. */
@Tags("Thorough")
class FirmwareSnippetsSpec : FunSpec({
    val root = Path.of("..").toRealPath()
    val library = root.resolve("javino-arduino").toFile()
    val documents = Document.all(root)
    val folder = tempdir()
    val warnings = "-Wall -Wextra -Werror"
    fun compiler(program: String): EnabledOrReasonIf = {
        if (onPath(program)) Enabled.enabled else Enabled.disabled("there is no $program: install g++ with your package manager")
    }

    test("there are sketches and C on the pages") {
        listOf("cpp", "c").forEach { language -> documents.flatMap { it.snippets }.filter { it.language == language }.shouldNotBeEmpty() }
    }

    context("a sketch for Arduino is") {
        documents.flatMap { it.snippets }.filter { it.language == "cpp" }.forEach { snippet ->
            test("$snippet").config(enabledOrReasonIf = compiler("c++")) {
                val sketch = folder.resolve("Sketch.ino").apply { writeText(snippet.text + "\n") }
                // adds the prototypes that the Arduino tools add
                library.runs("awk -f tests/prototypes.awk '$sketch' '$sketch' > '$folder/sketch.cpp'")
                library.runs("c++ -std=c++11 $warnings -Itests/stub -Isrc -c '$folder/sketch.cpp' -o '$folder/sketch.o'")
            }
        }
    }

    context("a program in C99 is") {
        documents.filter { page -> page.snippets.any { it.language == "c" } }.forEach { document ->
            test("$document").config(enabledOrReasonIf = compiler("cc")) {
                val body = document.snippets.filter { it.language == "c" }.joinToString("\n") { it.text }
                val program = folder.resolve("program.c").apply { writeText("$OF_THE_READER\nvoid program(void) {\n$body\n}\n") }
                library.runs("cc -std=c99 -pedantic $warnings -Isrc -Iextras/bare-metal -c '$program' -o '$folder/program.o'")
            }
        }
    }

    context("the compiler is called rightly in") {
        documents.flatMap(ToldCommand::of).filter { it.words[0] == "cc" }.forEach { command ->
            test("$command").config(enabledOrReasonIf = compiler("cc")) {
                library.runs(command.text.replace(Regex("-o (\\S+)$"), "-o '$folder/$1'"))
            }
        }
    }
})

/** The functions that the reader's own microcontroller must provide. */
private val OF_THE_READER = """
    #include <string.h>
    #include "javino_board.h"
    #include "javino_literal.h"
    #include "machine.h"
    void put_byte(void *context, uint8_t byte);
    uint32_t read_light(void);
    bool set_motor(int32_t speed);
    void stop_motors(void);
    void program(void);
""".trimIndent()

private fun onPath(program: String) = System.getenv("PATH").split(File.pathSeparator).any { File(it, program).canExecute() }

private fun File.runs(command: String) {
    val shell = ProcessBuilder("sh", "-c", command).directory(this).redirectErrorStream(true).start()
    val said = shell.inputReader().use { it.readText() }
    withClue("$command\n$said") { shell.waitFor() shouldBeExactly 0 }
}
