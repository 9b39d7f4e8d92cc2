package javino.sim

import io.kotest.core.test.Enabled
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries

/** Runs the board's library in C, through the program `src/test/c/board.c`. */
internal object LibraryBoards {
    private val sources = Path.of("../javino-arduino/src")
    private val program: Path by lazy(::compile)

    /** Whether there is a C compiler with the sanitizers. */
    val available: Enabled by lazy {
        val made = Files.createTempDirectory("argo-c")
        val reason = runCatching { cc(made.resolve("empty"), "-x", "c", "/dev/null", "-shared", "-fPIC") }
        made.toFile().deleteRecursively()
        if (reason.getOrNull()?.first == 0) Enabled.enabled
        else Enabled.disabled("needs a C compiler, cc, with its sanitizers, but: ${reason.getOrNull()?.second ?: reason.exceptionOrNull()}")
    }

    fun play(operations: List<String>): List<List<String>> {
        val script = Files.createTempFile("argo-c", ".txt")
        val output = Files.createTempFile("argo-c", ".txt")
        try {
            Files.write(script, operations)
            val process = ProcessBuilder(program.toString()).redirectInput(script.toFile()).redirectOutput(output.toFile())
                .redirectError(ProcessBuilder.Redirect.INHERIT).start()
            check(process.waitFor(LIMIT_S, TimeUnit.SECONDS)) { "the library still plays after $LIMIT_S s" }
            val answers = mutableListOf(mutableListOf<String>())
            for (line in Files.readAllLines(output)) if (line == ".") answers += mutableListOf<String>() else answers.last() += line
            check(process.exitValue() == 0) { "the library failed at ${operations.getOrNull(answers.size - 1)}" }
            return answers.dropLast(1)
        } finally {
            Files.delete(script)
            Files.delete(output)
        }
    }

    private fun compile(): Path {
        val directory = Files.createTempDirectory("argo-c").also { it.toFile().deleteOnExit() }
        val made = directory.resolve("board").also { it.toFile().deleteOnExit() }
        val files = sources.listDirectoryEntries().filter { it.extension == "c" }.map { it.toString() }
        val (status, output) = cc(made, "-Wall", "-Wextra", "-Werror", "-I$sources", "src/test/c/board.c", *files.toTypedArray())
        check(status == 0) { "the board's library does not compile:\n$output" }
        return made
    }

    private fun cc(made: Path, vararg arguments: String): Pair<Int, String> {
        val options = listOf("cc", "-std=c99", "-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all", "-o", "$made")
        val process = ProcessBuilder(options + arguments).redirectErrorStream(true).start()
        val output = process.inputReader().readText()
        check(process.waitFor(LIMIT_S, TimeUnit.SECONDS)) { "the compiler still runs after $LIMIT_S s" }
        return process.exitValue() to output
    }

    private const val LIMIT_S = 120L
}
