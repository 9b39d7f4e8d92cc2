package argo.fleet.trial

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import java.io.File
import kotlin.io.path.createTempDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.writeText
import kotlin.random.Random

/** An agent that outlives its computers. The computers are processes in network namespaces, which are killed and unplugged at random. */
@Tags("Thorough")
class OutlivingSpec : FunSpec({
    blockingTest = true

    test("it goes on elsewhere, and never acts twice at a time").config(
        enabledOrReasonIf = { Namespaces.missing?.let(Enabled::disabled) ?: Enabled.enabled },
    ) {
        val names = listOf("base", "scout1", "scout2")
        Namespaces(names).use { network ->
            Outliving(names, network).use { fleet ->
                names.forEach(fleet::start)
                val random = Random(1)
                repeat(6) {
                    val owner = fleet.awaitActs()
                    names.filterNot(fleet::isRunning).forEach(fleet::start)
                    if (random.nextBoolean()) fleet.kill(owner) else fleet.unplugFor(owner, random.nextLong(1000, 6000))
                }
                fleet.awaitActs()
                fleet.acts().map { it.about[1] }.distinct().size shouldBeGreaterThan 3
                History(fleet.acts()).faults().take(20).shouldBeEmpty()
            }
        }
    }
})

private class Outliving(names: List<String>, private val network: Namespaces) : AutoCloseable {
    private val folder = createTempDirectory("argo-fleet-outliving")
    private val running = HashMap<String, Process>()
    private var starts = 0

    init {
        val hosts = names.joinToString { "$it(\"${network.address(it)}\")" }
        folder.resolve("m.asl").writeText("!go. +!go <- argo.fleet.trial.acted; .wait(20); !go.")
        folder.resolve("trial.mas2j").writeText(
            "MAS trial { infrastructure: Fleet(hosts([$hosts]), insecure) agents: m at \"${names.joinToString()}\"; }",
        )
    }

    fun start(name: String) {
        val java = listOf(
            File(System.getProperty("java.home"), "bin/java").path, "-Xmx128m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1",
            "-D${acted.SESSION}=$name#${++starts}", "-cp", System.getProperty("java.class.path"),
        )
        running[name] = ProcessBuilder(network.prefix(name) + java + listOf("argo.fleet.MainKt", "trial.mas2j", "--at", name))
            .directory(folder.toFile()).redirectErrorStream(true).redirectOutput(folder.resolve("$name.out").toFile()).start()
    }

    fun isRunning(name: String) = name in running

    fun kill(name: String) {
        running.remove(name)?.destroyForcibly()?.waitFor()
    }

    fun unplugFor(name: String, millis: Long) {
        network.unplug(name)
        Thread.sleep(millis)
        network.plug(name)
    }

    /** The actions that the agent has noted. The last line may be incomplete. */
    fun acts(): List<Event> = folder.resolve(acted.NOTES).let { if (it.toFile().exists()) it.readLines() else emptyList() }
        .filter { it.split(' ').size == WORDS }.map(Event::of)

    /** Waits until the agent has acted ten more times. Returns its computer. */
    fun awaitActs(): String {
        val before = acts().size
        val end = System.nanoTime() + PATIENCE_NANOS
        while (acts().size < before + MORE) {
            check(System.nanoTime() < end) { "the agent does not act:\n${outputs()}" }
            Thread.sleep(PAUSE_MILLIS)
        }
        return acts().last().session.substringBefore('#')
    }

    /** The last printed lines of each computer. */
    private fun outputs() = folder.listDirectoryEntries("*.out").sorted().joinToString("\n") { file ->
        "${file.name}:\n" + file.readLines().takeLast(LINES).joinToString("\n")
    }

    override fun close() {
        running.keys.toList().forEach(::kill)
        folder.toFile().deleteRecursively()
    }

    private companion object {
        const val WORDS = 5
        const val MORE = 10
        const val LINES = 30
        const val PAUSE_MILLIS = 100L
        const val PATIENCE_NANOS = 60_000_000_000L
    }
}
