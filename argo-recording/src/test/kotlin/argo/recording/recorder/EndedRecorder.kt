package argo.recording.recorder

import java.util.concurrent.CountDownLatch
import java.util.logging.Logger

/** Records a message into the file that the argument names, as an agent would. Prints a line, and waits until it is ended. */
fun main(arguments: Array<String>) {
    val sink = SharedRecording.join(arguments.single(), Logger.getAnonymousLogger()).sink
    val channel = sink.channel("/robot/cycle", "argo.Cycle", "{}")
    sink.offer(channel, 1, "{}".encodeToByteArray())
    println("recorded")
    CountDownLatch(1).await()
}
