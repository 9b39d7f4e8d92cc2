package argo.tools.recording

import argo.mcap.McapMessage
import argo.mcap.McapReader
import argo.recording.replay.ClockDifference
import argo.recording.replay.JointRecordings
import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import java.nio.file.Path
import java.util.PriorityQueue

/**
 * The messages of several recordings, in the order of their times on the first recording's clock. Not safe for use by several threads at
 * once.
 *
 * @param readers the recordings, by file
 */
internal class JointMessages(private val readers: Map<Path, McapReader>) {
    /** A message, its file, and its time in ns by the first recording's clock. */
    class Timed(val file: Path, val ns: Long, val message: McapMessage)

    /** The lead of each recording's clock over the first recording's clock, or null if no messages between agents show it. */
    val differences: Map<Path, ClockDifference?> by lazy { differencesOf(readers.keys.toList()) }

    /** The time of the first message in ns, or null if there is none. */
    val firstNs: Long? get() = readers.mapNotNull { (file, reader) -> reader.times?.first?.minus(aheadNs(file)) }.minOrNull()

    private fun aheadNs(file: Path) = differences[file]?.ns ?: 0

    fun between(beginNs: Long, endNs: Long, topics: Set<String>?): Sequence<Timed> = sequence {
        val heads = PriorityQueue<Pair<Timed, Iterator<Timed>>>(compareBy { it.first.ns })
        fun next(rest: Iterator<Timed>) = if (rest.hasNext()) heads.add(rest.next() to rest) else false
        readers.forEach { (file, reader) -> next(timed(file, reader, beginNs, endNs, topics).iterator()) }
        while (heads.isNotEmpty()) {
            val (message, rest) = heads.remove()
            yield(message)
            next(rest)
        }
    }

    private fun timed(file: Path, reader: McapReader, beginNs: Long, endNs: Long, topics: Set<String>?): Sequence<Timed> {
        val ahead = aheadNs(file)
        val end = if (endNs == Long.MAX_VALUE) endNs else endNs + ahead
        return reader.messages(beginNs + ahead, end, topics).map { Timed(file, it.logTimeNs - ahead, it) }
    }

    private companion object {
        fun differencesOf(files: List<Path>): Map<Path, ClockDifference?> {
            if (files.size == 1) return mapOf(files.single() to ClockDifference.NONE)
            val opened = ArrayList<Pair<Path, Recording>>()
            try {
                files.forEach { file -> recordingOf(file)?.let { opened += file to it } }
                if (opened.firstOrNull()?.first != files.first()) return mapOf(files.first() to ClockDifference.NONE)
                return opened.map { it.first }.zip(JointRecordings(opened.map { it.second }).differencesOfClocks).toMap()
            } finally {
                opened.forEach { it.second.close() }
            }
        }

        fun recordingOf(file: Path): Recording? = try {
            Recording(file)
        } catch (_: RecordingException) {
            null
        }
    }
}
