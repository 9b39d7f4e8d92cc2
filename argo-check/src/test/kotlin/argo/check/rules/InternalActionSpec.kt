package argo.check.rules

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldHaveAtLeastSize
import io.kotest.matchers.shouldBe
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.InternalAction
import java.nio.file.Path
import java.util.jar.JarFile

/** The table has every internal action of both Jason versions, with its numbers of arguments. */
class InternalActionSpec : FunSpec({
    val here = Path.of(InternalAction::class.java.protectionDomain.codeSource.location.toURI())

    /** Returns the internal actions in [jar], as programs name them. Reads names only, since this Java may be too old for some classes. */
    fun actionsIn(jar: Path): List<String> = JarFile(jar.toFile()).use { file ->
        file.entries().asSequence().map { it.name }.filter { it.startsWith("jason/stdlib/") && it.endsWith(".class") && '$' !in it }
            .map { it.removePrefix("jason/stdlib").removeSuffix(".class").replace('/', '.') }.filter { it != ".Manual" }.toList()
    }

    test("each action of Jason 3.2.1 is there, with all numbers of arguments that it takes") {
        val actions = actionsIn(here)
        actions shouldHaveAtLeastSize 130
        val wrong = actions.filter { name ->
            val action = Class.forName("jason.stdlib$name").getDeclaredConstructor().newInstance() as? DefaultInternalAction
            val known = argo.check.rules.InternalAction.ALL[name]?.arities
            action != null && (known == null || action.minArgs !in known || action.maxArgs !in known)
        }
        wrong.shouldBeEmpty()
    }

    test("each action of the newest Jason is there") {
        actionsIn(Path.of(System.getProperty("newest.jason.jar"))).filter { it !in argo.check.rules.InternalAction.ALL }.shouldBeEmpty()
    }

    test("an action that only the newest Jason has says so") {
        val old = actionsIn(here)
        val since = argo.check.rules.InternalAction.ALL.values.filter { it.since != null }.map { it.name }
        since.filter { it in old }.shouldBeEmpty()
        since shouldBe listOf(".namespace_get_prop", ".namespace_set_prop")
    }
})
