package argo.recording.storage

import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** Records a message every 10 ms into the file that the argument names, and prints its time, until it is killed. */
fun main(arguments: Array<String>) {
    val file = RecordingFile.create(Path.of(arguments.single())) { error(it) }
    val channel = file.channel("/robot/cycle", "argo.Cycle", "{}")
    while (true) {
        val now = System.nanoTime()
        file.offer(channel, now, "{}".encodeToByteArray())
        println(now)
        TimeUnit.MILLISECONDS.sleep(10)
    }
}
