package argo.recording.recorder

import argo.Arch
import argo.orders.ProgramSource
import argo.platform.Plans
import argo.recording.Beginning
import argo.recording.CONFIG
import argo.recording.FORMAT
import argo.recording.agent.Counters
import argo.recording.agent.beginningOf
import argo.recording.agentMetadata
import argo.recording.storage.RecordSink
import jason.asSemantics.TransitionSystem
import jason.infra.local.BaseLocalMAS
import jason.infra.local.LocalAgArch
import jason.runtime.Settings
import jason.util.Config
import kotlinx.serialization.json.Json
import java.io.IOException

/**
 * Stores the program of the agent of [ts], with its included files and the agent's options. Also stores the versions of ARGO, Jason and
 * Java.
 *
 * @throws IOException if the program cannot be read, or if only the project's code can read it
 */
internal fun storeProgram(ts: TransitionSystem, sink: RecordSink): StoredProgram {
    val name = ts.agArch.agName
    val main = ProgramSource.at(ts.ag.aslSrc?.takeIf { it.isNotEmpty() } ?: throw IOException("it has no file with a program"))
    val program = StoredProgram(name, main, sink)
    BaseLocalMAS.getRunner()?.project?.takeIf { it.agents.isNotEmpty() }?.let { project ->
        sink.attach("program/${project.socName}.mas2j", "text/plain", "$project".encodeToByteArray()) // Jason does not keep the file's name
    }
    sink.metadata(
        agentMetadata(name),
        mapOf(
            "source" to program.main,
            "agentClass" to ts.ag.javaClass.name,
            "archClass" to generateSequence(ts.agArch) { it.nextAgArch }.first { it is Arch }.javaClass.name,
            "beliefBase" to ts.ag.bb.javaClass.name,
            "isConditional" to "${generateSequence(ts.agArch) { it.nextAgArch }.last() is LocalAgArch}",
            "firstLabel" to Counters.firstLabel(Plans.of(ts.ag).all)?.toString().orEmpty(),
            "address" to ts.ag.aslSrc.orEmpty(),
            "beginning" to Json.encodeToString(Beginning.serializer(), beginningOf(ts)),
        ) + ts.settings.userParameters.filterValues { it is String || it is Number }.map { (key, value) -> "option.$key" to "$value" } +
            inForce(ts.settings).map { (key, value) -> "option.$key" to value } +
            CONFIG.mapNotNull { key -> Config.get().getProperty(key)?.let { "config.$key" to it } },
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
    return program
}

/** Returns those [settings] that an infrastructure may change without an option. For example, an execution control makes agents wait. */
private fun inForce(settings: Settings) = mapOf(
    "events" to if (settings.requeue()) "requeue" else if (settings.retrieve()) "retrieve" else "discard",
    "intBels" to if (settings.sameFocus()) "sameFocus" else "newFocus",
    "nrcbp" to "${settings.nrcbp()}",
    "synchronised" to "${settings.isSync}",
    "tro" to "${settings.isTROon}",
)
