package benchmarks.fleet

import argo.fleet.trial.freePorts
import java.io.File
import java.nio.file.Path
import java.util.spi.ToolProvider
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

/**
 * A project of agents in its own folder, and its processes.
 *
 * @param mas2j the text of `bench.mas2j`
 * @param agents the agents' file names without `.asl`
 */
internal class Project(mas2j: String, agents: List<String>) : AutoCloseable {
    private val folder = createTempDirectory("argo-bench-fleet")
    private val processes = mutableListOf<Process>()

    init {
        file(MAS2J).writeText(mas2j)
        for (name in agents.map { "$it.asl" } + listOf("logging.properties", "jason.properties")) {
            file(name).writeText(Project::class.java.getResource("/fleet/$name")!!.readText())
        }
    }

    fun file(name: String): Path = folder.resolve(name)

    fun printed(): String = file(OUT).toFile().readText()

    private var classPath = System.getProperty("java.class.path")

    /** Packs the folders of the class path into jars. A class archive can only contain classes from jars. */
    fun packClasses() {
        val jar = ToolProvider.findFirst("jar").orElseThrow()
        classPath = classPath.split(File.pathSeparator).mapIndexed { place, it ->
            if (!File(it).isDirectory) return@mapIndexed it
            file("$place.jar").toString().also { packed -> jar.run(System.out, System.err, "--create", "--file", packed, "-C", it, ".") }
        }.joinToString(File.pathSeparator)
    }

    fun start(program: List<String>, options: List<String> = emptyList()): Process {
        val java = listOf(File(System.getProperty("java.home"), "bin/java").path) + options
        return ProcessBuilder(java + listOf("-cp", classPath) + program).directory(folder.toFile())
            .redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.appendTo(file(OUT).toFile())).start().also { processes += it }
    }

    fun startComputer(name: String): Process = start(computer(name))

    /** Returns the numbers in each line of the file [name], which agents write. The list is empty if there is no file. */
    fun noted(name: String): List<List<Long>> = file(name).toFile().takeIf { it.exists() }?.readLines().orEmpty()
        .map { line -> line.split(' ').map(String::toLong) }

    /** @throws IllegalStateException if [condition] does not hold within [seconds], or if no process runs any more */
    fun await(seconds: Int, what: String, condition: () -> Boolean) {
        val end = System.nanoTime() + seconds * 1_000_000_000L
        while (!condition()) {
            check(System.nanoTime() < end && processes.any { it.isAlive }) { "in vain: $what\n${printed().takeLast(2000)}" }
            Thread.sleep(50)
        }
    }

    override fun close() {
        processes.forEach { it.destroyForcibly().waitFor() }
        folder.toFile().deleteRecursively()
    }

    companion object {
        private const val OUT = "out.txt"
        const val MAS2J = "bench.mas2j"

        /** Returns the program and the arguments that run the computer [name] of the project in the file [mas2j]. */
        fun computer(name: String, mas2j: String = MAS2J): List<String> = listOf("argo.fleet.MainKt", mas2j, "--at", name)

        fun fleetOf(names: List<String>): String =
            "Fleet(name(bench), hosts([${names.zip(freePorts(names.size)).joinToString { (name, port) -> "$name(\"127.0.0.1:$port\")" }}]))"
    }
}
