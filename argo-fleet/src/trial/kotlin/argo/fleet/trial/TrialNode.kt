package argo.fleet.trial

import argo.fleet.cluster.ClusterSettings
import argo.fleet.cluster.JGroupsCluster
import java.io.File
import java.io.FileOutputStream
import java.net.InetSocketAddress
import java.nio.file.Path
import kotlin.concurrent.thread
import kotlin.random.Random
import kotlin.system.exitProcess

/** The greatest number of messages of a node without an end. A node sends some hundred messages per second. */
private const val UNDER_WAY = 500L
private const val LONGEST = 200
private const val PAUSE_MILLIS = 1L

/**
 * The program of one computer of a [Trial]. The arguments are `SESSION NOTES CERTIFICATES NAME=ADDRESS:PORT…`, where CERTIFICATES is a
 * folder or `-`. After the line `send` on its standard input, it sends messages to all computers, even to lost ones. After the line
 * `finish`, it waits for the ends of the messages. The program ends with its input. Changes of the computers in touch are printed.
 */
fun main(args: Array<String>) {
    val (session, notes, certificates) = args
    val hosts = args.drop(3).associate { it.substringBefore('=') to address(it.substringAfter('=')) }
    val here = session.substringBefore('#')
    val settings = ClusterSettings(
        "trial", here, hosts, hosts.getValue(here), certificates.takeIf { it != "-" }?.let(Path::of), insecure = certificates == "-",
    )
    val file = NoteFile(File(notes))
    val computer = Notes(JGroupsCluster.open(settings), session) {
        file.write(it)
        if (it.kind == Kind.VIEWED) println("${it.nanos} ${it.about[0]}")
    }
    val commands = generateSequence(::readlnOrNull).iterator()
    while (commands.hasNext()) when (val command = commands.next()) {
        "send" -> Sender(computer, hosts.keys.toList(), session.hashCode()).start()
        "finish" -> Sender.isEnding = true
        else -> System.err.println("unknown: $command")
    }
    exitProcess(0)
}

private fun address(text: String) = InetSocketAddress(text.substringBeforeLast(':'), text.substringAfterLast(':').toInt())

/** Passes each line to the operating system before the next step. A killed program then leaves all its notes. */
private class NoteFile(file: File) {
    private val out = FileOutputStream(file, true)

    @Synchronized
    fun write(event: Event) = out.write("$event\n".toByteArray())
}

private class Sender(private val computer: Notes, private val names: List<String>, seed: Int) {
    private val random = Random(seed)

    fun start() = thread(isDaemon = true) {
        while (!isEnding) {
            if (computer.underWay < UNDER_WAY) computer.send(names.random(random), random.nextInt(LONGEST))
            Thread.sleep(PAUSE_MILLIS)
        }
        while (computer.underWay > 0) Thread.sleep(PAUSE_MILLIS)
        computer.finish()
    }

    companion object {
        @Volatile
        var isEnding = false
    }
}
