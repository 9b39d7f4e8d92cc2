package samples.documents

import picocli.CommandLine
import picocli.CommandLine.ParameterException
import samples.program
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isExecutable
import kotlin.io.path.name
import kotlin.io.path.readText

/** Checks that the repository at [root] has everything that a command names: programs, options, tasks, modules, files. Runs no command. */
class CommandCheck(private val root: Path) {
    private val usage = ProcessBuilder("$root/argo").start().inputReader().use { it.readText() }

    /** The commands in the usage text of `./argo`. */
    val verbs: Set<String> = Regex("""(?m)^  ([a-z]+)[ \[]""").findAll(usage).map { it.groupValues[1] }.toSet()

    /** The commands of argo.jar. */
    val tools: Set<String> get() = TOOLS().subcommands.keys

    fun problem(words: List<String>): String? {
        if (words.first().startsWith("JDK_JAVA_OPTIONS=")) return problem(words.drop(1))
        val rest = words.drop(1).filterNot { it in PLACEHOLDERS }
        return when (words.first()) {
            "./argo" -> argo(rest)
            "java" -> java(rest)
            "timeout" -> problem(rest.drop(1))
            "mvn" -> maven(rest)
            "gradle", "./gradlew" -> gradle(rest)
            "make" -> listOf("Makefile", "tests/tests.mk").joinToString("") { root.resolve("javino-arduino/$it").readText() }.let { rules ->
                rest.firstOrNull { !Regex("(?m)^$it:").containsMatchIn(rules) }?.let { "the Makefile has no target $it" }
            }
            "./check", "./package", "./split" -> root.resolve("javino-arduino/${words.first()}").let { program ->
                missing(program.takeIf { it.isExecutable() }, words.first()) ?: unheardOf(program, rest)
            }
            "build/simulator" ->
                unheardOf(root.resolve("javino-arduino/simulator/main.c"), rest.map { it.trim('[', ']') }.filter { it.startsWith("--") })
            "alias" -> java(rest.single().substringAfter("=").split(" ").drop(1))
            "source" -> tool(rest.joinToString(" ").removePrefix("<(argo ").removeSuffix(")").split(" "))
            else -> "nothing is known of ${words.first()}"
        }
    }

    private fun argo(words: List<String>): String? {
        val verb = words.firstOrNull() ?: return null
        val rest = words.drop(1)
        return when (verb) {
            !in verbs -> "./argo has no $verb, it has: ${verbs.joinToString()}"
            "demo" -> sample(words)
            "experiment" -> experiment(rest)
            "sample" -> if (rest.isEmpty()) null else sample(rest)
            "tools" -> tool(rest)
            "new" -> if (rest.isEmpty()) null else tool(words)
            "explore" -> tool(words)
            "bench" -> rest.firstOrNull()?.takeUnless { Regex("""\b$it \(""").containsMatchIn(usage) }?.let { "./argo bench has no $it" }
            "board" -> if (rest.isEmpty() || rest.any { it.endsWith(".ino") }) null else "./argo board takes a sketch"
            "test" -> if (rest.isEmpty() || rest == listOf("--all")) null else "./argo test takes --all or nothing"
            "dist" -> if (rest.isEmpty() || rest == listOf("--bundle")) null else "./argo dist takes --bundle or nothing"
            "format" -> rest.firstOrNull { it !in usage }?.let { "./argo format knows nothing of $it" }
            else -> if (rest.isEmpty()) null else "./argo $verb takes no arguments"
        }
    }

    private fun sample(words: List<String>): String? = program(words.toTypedArray()).let { (commands, arguments) ->
        refusal(commands, arguments.asList())
    }

    /** Checks only the names of options, since the experiment's module depends on this one. */
    private fun experiment(options: List<String>): String? {
        val sources = root.resolve("experiment/src/main/kotlin/experiment")
        val own = sources.resolve("ExperimentCommand.kt").readText()
        val others = options.filter { it.startsWith("--") }.map { "\"${it.substringBefore('=')}\"" }.filterNot { it in own }
        return unheardOf(sources.resolve("RunsCommand.kt"), others)
    }

    private fun tool(words: List<String>): String? = when (words.firstOrNull()) {
        "demo" -> sample(words)
        "experiment" -> experiment(words.drop(1))
        "sample" -> sample(words.drop(1))
        else -> refusal(TOOLS(), words)
    }

    private fun refusal(commands: CommandLine, words: List<String>): String? = try {
        commands.parseArgs(*words.toTypedArray())
        null
    } catch (refused: ParameterException) {
        refused.message
    }

    private fun java(words: List<String>): String? {
        val options = words.takeWhile { it.startsWith("--") || it.startsWith("-Xmx") }
        val rest = words.drop(options.size)
        return when {
            options.any { !JAVA_OPTIONS.matches(it) } -> "an option that Java has not: $options"
            rest.isEmpty() -> null
            rest[0] == "-jar" -> when (Path.of(rest[1]).name) {
                "argo.jar" -> tool(rest.drop(2))
                "argo-fleet.jar" -> fleet(rest.drop(2))
                else -> "there is no ${rest[1]}"
            }
            rest[0].endsWith(".java") -> missing(root.resolve(rest[0]).takeIf { it.exists() }, rest[0])
            rest[0] == "-cp" -> missing(runCatching { Class.forName(rest[2], false, javaClass.classLoader) }.getOrNull(), rest[2])
            else -> "Java is not told what to run"
        }
    }

    private fun fleet(words: List<String>): String? = unheardOf(
        root.resolve("argo-fleet/src/main/kotlin/argo/fleet/FleetCommand.kt"), words.filter { it.startsWith("--") }.map { "\"$it\"" },
    )

    private fun maven(words: List<String>): String? {
        val own = listOf(root.resolve("pom.xml"), root.resolve(NEW_PROJECT).resolve("pom.xml")).joinToString("\n") { it.readText() }
        val module = words.getOrNull(words.indexOf("-pl") + 1).takeIf { "-pl" in words }
        return words.filterNot { it == module }.firstNotNullOfOrNull { word ->
            when {
                word in setOf("-q", "-o", "-B", "-am", "-pl", "-Dmaven.test.skip") || word in GOALS || word.startsWith("-Dsurefire.") ->
                    null
                word.startsWith("-DincludeScope=") || word.startsWith("-DoutputDirectory=") ->
                    missing("dependency:copy-dependencies".takeIf { it in words }, "goal for $word")
                word.startsWith("-Dtest=") -> missing(source("${word.removePrefix("-Dtest=")}.kt"), word)
                word.startsWith("-D") ->
                    missing("<${word.removePrefix("-D").substringBefore('=')}>".takeIf { it in own }, "a property of $word")
                ":" in word ->
                    missing("<artifactId>${word.substringBefore(':')}-maven-plugin</artifactId>".takeIf { it in own }, "a plugin for $word")
                else -> "Maven has no $word"
            }
        } ?: module?.let { missing(root.resolve("$it/pom.xml").takeIf { pom -> pom.exists() }, "a module $it") }
    }

    private fun gradle(words: List<String>): String? = words.firstNotNullOfOrNull { word ->
        val task = word.substringAfterLast(':')
        val build = word.substringBeforeLast(':', "").trim(':').let {
            if (it.isEmpty()) root.resolve("build.gradle.kts") else root.resolve("$it/build.gradle.kts")
        }
        when {
            word.startsWith("-P") -> word.removePrefix("-P").substringBefore('=').let { property ->
                missing(property.takeIf { "<$it>" in root.resolve("pom.xml").readText() }, "a property of $word")
            }
            word.startsWith("-D") -> {
                val areOfAgents = "System.properties.findAll { it.key.startsWith('argo_') }"
                val isKnown = word.startsWith("-Dargo_") && areOfAgents in root.resolve(NEW_PROJECT).resolve("build.gradle").readText()
                missing(word.takeIf { isKnown }, "a property of $word")
            }
            word.startsWith("--args=") -> sample(word.removePrefix("--args=").split(" "))
            !build.exists() -> "there is no project for $word"
            task == "build" || task == "test" -> null
            task == "publishToMavenLocal" -> missing("maven-publish".takeIf { it in build.readText() }, "the plugin maven-publish")
            task == "run" && ':' in word -> missing("application".takeIf { it in build.readText() }, "the plugin application in $word")
            else -> missing("'$task'".takeIf { it in root.resolve(NEW_PROJECT).resolve("build.gradle").readText() }, "a task $task")
        }
    }

    private fun source(name: String): Path? = root.toFile().walk()
        .onEnter { it == root.toFile() || it.name !in setOf("target", "build", ".git") }.find { it.name == name }?.toPath()

    private fun unheardOf(program: Path, options: List<String>): String? {
        val text = program.readText()
        return options.find { it !in text }?.let { "$program knows nothing of $it" }
    }

    private fun missing(found: Any?, what: String): String? = if (found == null) "there is no $what" else null

    private companion object {
        const val NEW_PROJECT = "argo-tools/src/main/resources/argo/tools/project"

        val JAVA_OPTIONS = Regex("--enable-native-access=ALL-UNNAMED|--sun-misc-unsafe-memory-access=allow|-Xmx\\d+m")

        /** Standard goals and phases of Maven. */
        val GOALS = setOf("clean", "compile", "test", "package", "verify", "install", "dependency:copy-dependencies")

        /** Words that stand for any word. */
        val PLACEHOLDERS = setOf("COMMAND", "…")

        /** The command line of argo.jar, which is internal to the tools. */
        val TOOLS: () -> CommandLine = Class.forName("argo.tools.MainKt").getMethod("tools").let { tools ->
            { tools.invoke(null) as CommandLine }
        }
    }
}
