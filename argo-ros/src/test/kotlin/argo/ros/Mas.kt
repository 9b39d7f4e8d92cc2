package argo.ros

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.matchers.shouldBe
import jason.infra.local.RunLocalMAS
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import kotlinx.coroutines.runBlocking
import java.nio.file.Files
import kotlin.io.path.createTempDirectory
import kotlin.io.path.writeText

internal class Mas(program: String, vararg options: Pair<String, String>) : AutoCloseable {
    private val directory = createTempDirectory("argo-ros-mas")
    private val mas = RunLocalMAS()

    init {
        val logging = directory.resolve("logging.properties").apply { writeText("handlers =\n.level = INFO\n") }
        mas.init(arrayOf("--empty-mas", "--no-net", "--log-conf", "$logging"))
        mas.create()
        mas.start()
        val source = directory.resolve("bob.asl").apply { writeText(program) }
        val settings = Settings().apply { options.forEach { (name, value) -> addOption(name, value) } }
        val services = RuntimeServicesFactory.get()
        services.startAgent(services.createAgent("bob", "$source", null, listOf("argo.Arch"), null, settings, null))
    }

    fun beliefs(): Set<String> = mas.getAg("bob").ts.ag.bb.asSequence().map { it.copy().apply { clearAnnots() }.toString() }.toSet()

    suspend fun awaitBelief(belief: String) = eventually(LIMIT) { withClue({ beliefs() }) { (belief in beliefs()) shouldBe true } }

    suspend fun awaitNoBelief(belief: String) = eventually(LIMIT) { withClue({ beliefs() }) { (belief in beliefs()) shouldBe false } }

    override fun close() {
        mas.finish(0, false, 0) // on a thread of its own
        runBlocking { eventually(LIMIT) { mas.ags.keys.toSet() shouldBe emptySet() } }
        Files.walk(directory).use { files -> files.sorted(Comparator.reverseOrder()).forEach(Files::delete) }
    }
}
