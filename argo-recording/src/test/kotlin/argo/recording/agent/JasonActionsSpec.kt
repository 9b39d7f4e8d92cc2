package argo.recording.agent

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveAtLeastSize
import io.kotest.matchers.shouldBe
import jason.asSemantics.InternalAction
import java.nio.file.Path
import java.util.jar.JarFile

/** Checks that the table has each internal action and function of the newest and of the used version of Jason. */
class JasonActionsSpec : FunSpec({
    val here = Path.of(InternalAction::class.java.protectionDomain.codeSource.location.toURI())

    /**
     * Returns the class names of the actions and functions in [jar], without loading the classes, since this Java may be too old for some.
     */
    fun codeIn(jar: Path): List<String> = JarFile(jar.toFile()).use { file ->
        file.entries().asSequence().map { it.name }.filter { it.startsWith("jason/stdlib/") || it.startsWith("jason/functions/") }
            .filter { it.endsWith(".class") && '$' !in it }.map { it.removeSuffix(".class").replace('/', '.') }
            .filter { it != "jason.stdlib.Manual" }.toList() // a program that prints their descriptions
    }

    for (jar in listOf(here, Path.of(System.getProperty("newest.jason.jar")))) {
        test("that of ${jar.fileName}") {
            val code = codeIn(jar)
            code shouldHaveAtLeastSize 150
            code.filter { JasonActions.natureOf(it) == null }.shouldBeEmpty()
        }
    }

    test("what changes files, agents or the infrastructure is an effect, and what comes from them an input") {
        listOf("save_agent", "create_agent", "clone", "kill_agent", "stopMAS", "df_register").forEach {
            JasonActions.natureOf("jason.stdlib.$it") shouldBe Nature.EFFECT
        }
        listOf("list_files", "random", "date", "all_names").forEach { JasonActions.natureOf("jason.stdlib.$it") shouldBe Nature.INPUT }
    }
})
