package argo.recording.recorder

import argo.observing.Farewell
import argo.recording.storage.RecordSink
import argo.recording.storage.RecordingFile
import argo.recording.storage.RecordingRing
import java.io.IOException
import java.nio.file.AccessDeniedException
import java.nio.file.FileAlreadyExistsException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.time.Duration
import java.time.LocalDateTime
import java.time.format.DateTimeFormatter
import java.util.logging.Logger

/** The recording of all agents of a program with one value of the option. Safe for use by several threads. */
internal class SharedRecording private constructor(val sink: RecordSink, private val key: String, private val log: Logger) {
    private var agents = 0

    /**
     * Closes the recording's file when Java ends, so that the last part is not missing after Ctrl-C. A ring, which keeps the last minutes
     * in memory, is written only on request.
     */
    private val farewell = (sink as? RecordingFile)?.let { file ->
        Farewell(MAX_FAREWELL_MS, "argo_record: the program has ended before all that was recorded was in ${file.path}", say = file::close)
    }

    /** Writes a ring to a file in [folder], on a separate thread. Does nothing if the recording is in a file. */
    fun save(folder: Path = Path.of("")) {
        val ring = sink as? RecordingRing ?: return
        Thread({
            val file = folder.resolve("recording-${LocalDateTime.now().format(STAMP)}.mcap")
            try {
                ring.save(file)
                log.info("the last minutes are recorded in $file")
            } catch (trouble: Exception) { // report every failure
                log.warning("the last minutes cannot be written to $file: ${wordsOf(trouble)}")
            }
        }, "argo-save-recording").apply { isDaemon = true }.start()
    }

    /** Calls [use] with a file that contains the recording so far. The call waits for the disk. */
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

    /** Removes an agent that ends. Closes the recording with its last agent. */
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

        /** Matches the option's value for a ring, and captures the number of minutes. */
        val LAST = Regex("""last\(([1-9]\d{0,3})\)""")

        /**
         * Adds an agent to the recording for the option's [value], which names a file or the last minutes. Returns the recording.
         *
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

/** Returns in words why a file cannot be made or written. Of many exceptions, Java's message is only the file's name. */
internal fun wordsOf(trouble: Exception): String = when (trouble) {
    is NoSuchFileException -> "its folder is not there"
    is AccessDeniedException -> "this user may not write ${trouble.file}"
    is FileAlreadyExistsException -> "${trouble.file} is no folder"
    is FileSystemException -> "${trouble.file}: ${trouble.reason ?: trouble.javaClass.simpleName}"
    is IOException -> trouble.message ?: "$trouble"
    else -> "$trouble"
}
