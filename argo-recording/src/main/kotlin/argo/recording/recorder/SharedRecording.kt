package argo.recording.recorder

import argo.observing.Farewell
import argo.recording.storage.RecordSink
import argo.recording.storage.RecordingFile
import argo.recording.storage.RecordingRing
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.time.LocalDateTime
import java.time.format.DateTimeFormatter
import java.util.logging.Logger

/** A recording of all agents of a program that ask for the same. Safe for use by several threads. */
internal class SharedRecording private constructor(val sink: RecordSink, private val key: String, private val log: Logger) {
    private var agents = 0

    /** Or Ctrl-C would cost the end of a file. The last minutes are written where they are asked for, and not at each end of a program. */
    private val farewell = if (sink is RecordingFile) Farewell(MAX_FAREWELL_MS, sink::close) else null

    /** Writes a ring to a file, on a thread of its own. Does nothing to a recording that is written anyway. */
    fun save() {
        val ring = sink as? RecordingRing ?: return
        Thread({
            val file = Path.of("recording-${LocalDateTime.now().format(STAMP)}.mcap")
            try {
                ring.save(file)
                log.info("the last minutes are recorded in $file")
            } catch (trouble: Exception) { // whatever it is, the thread does not end in silence
                log.warning("the last minutes cannot be written to $file: $trouble")
            }
        }, "argo-save-recording").apply { isDaemon = true }.start()
    }

    /** Calls [use] with a file of all that has been recorded. Waits for the disk. */
    fun <T> read(use: (Path) -> T): T {
        if (sink is RecordingFile) {
            sink.flush()
            return use(sink.path)
        }
        val file = Files.createTempFile("argo-recording", ".mcap")
        try {
            (sink as RecordingRing).save(file)
            return use(file)
        } finally {
            Files.deleteIfExists(file)
        }
    }

    /** An agent ends; the last one closes the recording. */
    fun leave() = synchronized(OPEN) {
        if (--agents == 0) {
            OPEN -= key
            sink.close()
            farewell?.close()
        }
    }

    companion object {
        private val OPEN = HashMap<String, SharedRecording>()
        private const val MAX_FAREWELL_MS = 5000L
        private val STAMP = DateTimeFormatter.ofPattern("yyyyMMdd-HHmmss-SSS")

        /** The last minutes, and how many. */
        val LAST = Regex("""last\(([1-9]\d{0,3})\)""")

        /**
         * The recording that [value], the option of an agent, names: a file, or the last minutes.
         * @throws IOException if the file cannot be made
         */
        fun join(value: String, log: Logger): SharedRecording = synchronized(OPEN) {
            OPEN.getOrPut(value) { SharedRecording(open(value, log), value, log) }.also { it.agents++ }
        }

        private fun open(value: String, log: Logger): RecordSink {
            val minutes = LAST.matchEntire(value)?.groupValues?.get(1)?.toInt()
            if (minutes != null) return RecordingRing(Duration.ofMinutes(minutes.toLong()), warn = log::warning)
            return RecordingFile.create(Path.of(value), log::warning).also { log.info("recording to ${it.path}") }
        }
    }
}
