package javino.virtual

import javino.ActionUnconfirmedException
import javino.PerceptsRequest
import javino.PortTimeoutException
import javino.Protocol
import javino.link.Link
import javino.link.LinkSettings
import javino.link.SendOptions
import javino.sim.VirtualBoard2
import java.util.concurrent.CompletableFuture

/**
 * Makes [exchanges] exchanges with a board of version 2 on a faulty line of 115,200 baud, and counts the outcomes. Four commands and four
 * requests alternate. A request asks for nine percepts and waits 500 ms for the answer.
 */
internal class FaultyExchanges(private val exchanges: Int, toBoard: LineFaults, toComputer: LineFaults) {
    private val carriedOut = ByteArray(exchanges / 2 + 1)
    private val confirmed = BooleanArray(exchanges / 2 + 1)
    private var last = 0

    var answered = 0
        private set

    var corruptFrames = 0L
        private set

    /** Descriptions of violations: commands that were carried out wrongly or out of order, or confirmed but not carried out. */
    val wrong = mutableListOf<String>()

    /** Answers that the computer accepted although the board did not send them. */
    val corruptBelieved = mutableListOf<String>()

    val confirmations: Int get() = confirmed.count { it }

    val twice: Int get() = carriedOut.count { it > 1 }

    init {
        val board = VirtualBoard2()
        board.answer = ::ninePercepts
        board.onReceived = { }
        board.onHandled = ::note
        EventLine(FAST.withProtocol(Protocol.V2), board, toBoard, toComputer).use { line ->
            for (i in 1..exchanges / 2 step ROW) {
                val row = (i until minOf(i + ROW, exchanges / 2 + 1)).map { line.link.send("speed($it)", SendOptions.defaults()) }
                ask(line.link)
                for (n in 1 until row.size) ask(line.link)
                line.link.settle(row)
                row.forEachIndexed { n, outcome -> note(i + n, outcome) }
            }
            corruptFrames = line.link.corruptFrames()
        }
        for (i in confirmed.indices) {
            if (confirmed[i] && carriedOut[i].toInt() == 0) wrong += "speed($i) is confirmed and was not carried out"
        }
    }

    private fun note(handled: String) {
        if (PerceptsRequest.ALL in handled || handled.startsWith("1:")) return
        val action = COMMAND.matchEntire(handled)?.groupValues?.get(1)?.toInt()
        if (action == null || action !in carriedOut.indices || action < last) wrong += "the board did $handled after speed($last)"
        else last = action.also { carriedOut[it]++ }
    }

    private fun note(i: Int, outcome: CompletableFuture<Void>) {
        val trouble = outcome.handle { _, trouble -> trouble }.join()
        confirmed[i] = trouble == null
        if (trouble != null && trouble !is ActionUnconfirmedException) wrong += "$trouble"
    }

    private fun ask(link: Link) {
        try {
            val text = link.request(PerceptsRequest.ALL, LIMIT_MS).text()
            answered++
            if (text != ninePercepts(numberIn(text))) corruptBelieved += text
        } catch (_: PortTimeoutException) {
            return
        }
    }

    /** Works on the line until the outcomes are known, because no other thread does. */
    private fun Link.settle(row: List<CompletableFuture<Void>>) {
        while (row.any { !it.isDone }) watch(10)
    }

    companion object {
        val FAST: LinkSettings = LinkSettings.defaults().withBaud(115_200).withBootMillis(0)

        /** Number of commands in a row. Also the number of requests in a row. */
        private const val ROW = 4
        private const val LIMIT_MS = 500
        private val COMMAND = Regex("2:speed\\((\\d+)\\)")

        fun ninePercepts(n: Int): String = "count($n,${n * 31L % 1009});" + "dist(f,$n);".repeat(8)

        fun numberIn(answer: String): Int = answer.substringAfter('(').substringBefore(',').toIntOrNull() ?: 0
    }
}
