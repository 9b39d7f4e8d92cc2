package argo.recording

import argo.mcap.McapWriter
import java.nio.channels.FileChannel
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.WRITE

internal fun made(
    program: String,
    values: Map<String, String> = emptyMap(),
    files: Map<String, String> = emptyMap(),
    // a cycle with isEnding may differ in a replay
    cycles: List<String> = (1..12).map { """{"index":$it,"number":$it,"ns":$it,"isEnding":true}""" },
    keyFrame: String? = null,
): Path {
    val file = recordingFile()
    McapWriter(FileChannel.open(file, CREATE_NEW, WRITE)).use { writer ->
        writer.metadata("argo.recording", mapOf("format" to FORMAT))
        val agent = mapOf(
            "source" to "program/bob/bob.asl", "agentClass" to "jason.asSemantics.Agent", "archClass" to "argo.Arch",
            "beliefBase" to "jason.bb.DefaultBeliefBase", "isConditional" to "true",
        )
        writer.metadata("agent/bob", agent + values)
        for ((name, text) in mapOf("program/bob/bob.asl" to program) + files) {
            writer.attachment(name, "text/plain", text.encodeToByteArray())
        }
        val cycle = writer.channel("/bob/cycle", writer.schema("argo.Cycle", "{}"))
        cycles.forEach { writer.message(cycle, 1, 0, it.encodeToByteArray()) }
        val frame = writer.channel("/bob/keyframe", writer.schema("argo.KeyFrame", "{}"))
        if (keyFrame != null) writer.message(frame, 1, 0, keyFrame.encodeToByteArray())
    }
    return file
}
