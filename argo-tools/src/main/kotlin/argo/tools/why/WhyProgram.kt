package argo.tools.why

import argo.tools.command.QUICK_START
import argo.tools.command.awaitEnd
import argo.tools.command.classPathWithJason
import argo.tools.command.java
import argo.tools.command.missingJason
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit

/**
 * The answer of the tool `why`.
 *
 * @property lines the sentences of the answer. Two blanks of indentation stand for one level of causes. Empty if there is no answer
 * @property trouble the reason why there is no answer, or the missing parts of the recording; empty if the answer is complete
 */
class Told(val lines: List<String>, val trouble: String)

/**
 * Runs the tool `why` in a Java process of its own. A replay changes Jason's counters for all agents of its process, and takes memory and
 * processor time. A program with running agents must therefore not replay one itself. Answers one question at a time. Any thread may ask.
 *
 * @param patienceS the longest wait for an answer, in s
 */
class WhyProgram(private val patienceS: Long) {
    /**
     * Asks why [agent] sent its command [number] in the recordings [files], and waits for the answer. [number] counts only commands to
     * boards.
     * @throws java.io.IOException if the process cannot be started
     */
    @Synchronized
    fun ask(files: List<Path>, agent: String, number: Long): Told {
        val path = classPathWithJason(null) ?: return Told(emptyList(), missingJason())
        val errors = Files.createTempFile("argo-why", ".txt")
        try {
            val program = QUICK_START + IN_UNICODE + listOf("-cp", path, "argo.tools.MainKt", "why") +
                files.map(Path::toString) + listOf("#$number", "--of=$agent")
            val process = java(program).redirectError(errors.toFile()).start()
            CompletableFuture.delayedExecutor(patienceS, TimeUnit.SECONDS).execute(process::destroyForcibly)
            val lines = process.inputStream.bufferedReader().readLines()
            val status = process.awaitEnd()
            val trouble = Files.readString(errors).trim()
            return Told(lines, if (status == KILLED) tooLong(number) else trouble)
        } finally {
            Files.deleteIfExists(errors)
        }
    }

    private fun tooLong(number: Long) = "the replay did not come to the command within $patienceS s; it has no limit in a terminal: " +
        "java -jar argo.jar why FILE '#$number'"

    private companion object {
        /** Options for UTF-8 output on every computer. */
        val IN_UNICODE = listOf("file", "stdout", "stderr").map { "-D$it.encoding=UTF-8" }

        const val KILLED = 137
    }
}
