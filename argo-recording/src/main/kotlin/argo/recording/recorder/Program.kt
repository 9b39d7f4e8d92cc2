package argo.recording.recorder

import argo.Arch
import argo.recording.FORMAT
import argo.recording.agentMetadata
import argo.recording.storage.RecordSink
import jason.asSemantics.TransitionSystem
import jason.infra.local.BaseLocalMAS
import jason.infra.local.LocalAgArch
import jason.util.Config
import java.io.IOException

/**
 * Stores the program of the agent of [ts] with all files that it includes, its options and all versions.
 * @throws IOException if the program cannot be read, or only by code of the project
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
        ) + ts.settings.userParameters.filterValues { it is String || it is Number }.map { (key, value) -> "option.$key" to "$value" },
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
