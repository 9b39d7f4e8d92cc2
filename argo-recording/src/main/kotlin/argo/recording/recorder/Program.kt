package argo.recording.recorder

import argo.Arch
import argo.platform.Plans
import argo.recording.Beginning
import argo.recording.FORMAT
import argo.recording.agent.Counters
import argo.recording.agent.beginningOf
import argo.recording.agentMetadata
import argo.recording.programName
import argo.recording.storage.RecordSink
import jason.asSemantics.TransitionSystem
import jason.asSyntax.Rule
import jason.infra.local.BaseLocalMAS
import jason.infra.local.LocalAgArch
import jason.runtime.Settings
import jason.util.Config
import kotlinx.serialization.json.Json
import java.io.IOException
import java.net.URI
import java.net.URISyntaxException
import java.nio.file.Files
import java.nio.file.Path

/** Stores the program of the agent of [ts], its options and all versions. */
internal fun storeProgram(ts: TransitionSystem, sink: RecordSink) {
    val name = ts.agArch.agName
    val files = sources(ts)
    val root = commonDirectory(files)
    files.forEach { sink.attach(programName(name, root.relativize(it)), it) }
    BaseLocalMAS.getRunner()?.project?.takeIf { it.agents.isNotEmpty() }?.let { project ->
        sink.attach("program/${project.socName}.mas2j", "text/plain", "$project".encodeToByteArray()) // Jason does not keep the file's name
    }
    val main = fileOf(ts.ag.aslSrc)
    sink.metadata(
        agentMetadata(name),
        mapOf(
            "source" to main?.let { programName(name, root.relativize(it)) }.orEmpty(),
            "agentClass" to ts.ag.javaClass.name,
            "archClass" to generateSequence(ts.agArch) { it.nextAgArch }.first { it is Arch }.javaClass.name,
            "beliefBase" to ts.ag.bb.javaClass.name,
            "isConditional" to "${generateSequence(ts.agArch) { it.nextAgArch }.last() is LocalAgArch}",
            "firstLabel" to Counters.firstLabel(Plans.of(ts.ag).all)?.toString().orEmpty(),
            "address" to ts.ag.aslSrc.orEmpty(),
            "beginning" to Json.encodeToString(Beginning.serializer(), beginningOf(ts)),
        ) + ts.settings.userParameters.filterValues { it is String || it is Number }.map { (key, value) -> "option.$key" to "$value" } +
            inForce(ts.settings).map { (key, value) -> "option.$key" to value } +
            CONFIG.mapNotNull { key -> Config.get().getProperty(key)?.let { "config.$key" to it } } +
            BaseLocalMAS.getRunner()?.project?.directiveClasses.orEmpty().map { (name, type) -> "directive.$name" to type },
    )
    sink.metadata(
        "argo.recording",
        mapOf(
            "format" to FORMAT,
            "argo" to (Arch::class.java.`package`.implementationVersion ?: "unknown"),
            "jason" to Config.get().jasonVersion,
            "java" to System.getProperty("java.version"),
        ),
    )
}

/** The [settings] that an infrastructure may set besides the options, such as an execution control, which has its agents wait for it. */
private fun inForce(settings: Settings) = mapOf(
    "events" to if (settings.requeue()) "requeue" else if (settings.retrieve()) "retrieve" else "discard",
    "intBels" to if (settings.sameFocus()) "sameFocus" else "newFocus",
    "nrcbp" to "${settings.nrcbp()}",
    "synchronised" to "${settings.isSync}",
    "tro" to "${settings.isTROon}",
)

/** Settings of Jason's, for all agents, that change what agents do. */
private val CONFIG = listOf(Config.SHORT_UNNAMED_VARS, Config.KQML_RECEIVED_FUNCTOR)

/** Stores the text of [file], if it has not gone since Jason read it. */
private fun RecordSink.attach(name: String, file: Path) {
    val text = try {
        Files.readAllBytes(file)
    } catch (_: IOException) {
        return
    }
    attach(name, "text/plain", text)
}

/** The files that the agent's program has been read from. */
private fun sources(ts: TransitionSystem): List<Path> {
    val names = Plans.of(ts.ag).all.map { it.sourceFile } + ts.ag.bb.filterIsInstance<Rule>().map { it.srcInfo?.srcFile } + ts.ag.aslSrc
    return names.mapNotNull(::fileOf).distinct().filter(Files::isRegularFile)
}

private fun fileOf(source: String?): Path? = try {
    if (source == null || source.startsWith("jar:")) null
    else (if (source.startsWith("file:/")) Path.of(URI(source)) else Path.of(source.removePrefix("file:"))).toAbsolutePath().normalize()
} catch (_: URISyntaxException) {
    null
} catch (_: IllegalArgumentException) {
    null // an .asl from a jar or the class path
}

private fun commonDirectory(files: List<Path>): Path =
    files.map { it.parent }.reduceOrNull { one, other -> generateSequence(one) { it.parent }.first(other::startsWith) }
        ?: Path.of("").toAbsolutePath()
