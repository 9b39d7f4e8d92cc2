package argo.filters

import org.jetbrains.kotlin.cli.common.ExitCode
import org.jetbrains.kotlin.cli.jvm.K2JVMCompiler
import java.io.ByteArrayOutputStream
import java.io.File
import java.io.PrintStream

/** Compiles [declarations] and [statements], and keeps the compiler's messages. Each statement is in a function on its own line. */
class Compilation(directory: File, statements: List<String>, private val declarations: String) {
    private val messages = ByteArrayOutputStream()
    private val firstLine = declarations.lines().size + 1

    val exit: ExitCode

    init {
        val source = directory.resolve("Snippets.kt")
        val functions = statements.mapIndexed { number, statement -> "fun snippet$number() { $statement }" }
        source.writeText((listOf(declarations) + functions).joinToString("\n"))
        exit = K2JVMCompiler().exec(
            PrintStream(messages), "-no-stdlib", "-no-reflect", "-classpath", classPath(), "-jvm-target", "17", "-d",
            directory.resolve("out").path, source.path,
        )
    }

    fun errors(statement: Int): List<String> =
        "$messages".lines().filter { "Snippets.kt:${firstLine + statement}:" in it && "error:" in it }

    override fun toString() = "$messages"

    private fun classPath() = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
}
