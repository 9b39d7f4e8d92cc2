package argo.tools.board

import argo.links.BoardLinkProvider
import javino.LineClock
import javino.NoSuchPortException
import javino.PerceptsRequest
import javino.PortException
import javino.PortTimeoutException
import javino.Protocol
import javino.link.Link
import javino.link.LinkSettings
import javino.link.StrayBytes

/**
 * The result of a probe, in words.
 *
 * @property answers true if a Javino board answers, or null if that is unknown
 * @property description the board's description, or null if it was not requested or does not exist
 */
internal data class ProbedBoard(
    val result: String,
    val answers: Boolean?,
    val isMissing: Boolean = false,
    val description: Description? = null,
)

/**
 * Finds out if a Javino board answers at a port. Tries the rates one by one. Opening a port resets most boards.
 *
 * @param rates the rates to try, in bits per second, at least one. For a port without rates, such as `sim:robot`, only the first one is
 * used
 * @param describes true if the board is also asked for its description
 */
internal class Probe(private val rates: List<Int>, private val describes: Boolean = false) {
    /** Probes the port [name]. The probe takes up to four seconds for each rate without an answer. */
    fun of(name: String): ProbedBoard = try {
        BoardLinkProvider.of(name)?.let { elsewhere(name, it) } ?: onLine(name)
    } catch (missing: NoSuchPortException) {
        ProbedBoard(missing.message.orEmpty(), answers = false, isMissing = true)
    } catch (trouble: PortException) {
        ProbedBoard(trouble.message.orEmpty(), answers = null)
    }

    private fun onLine(name: String): ProbedBoard {
        val tried = if (SCHEMES.any(name::startsWith)) rates.take(1) else rates
        val strays = ArrayList<StrayBytes>()
        for (rate in tried) {
            val board = at(name, rate, strays)
            if (board != null) return board
            // readable text means that the rate is right and the board speaks no Javino
            if (strays.last().run { count > 0 && isText }) break
        }
        val telling = strays.maxWith(compareBy({ it.count > 0 && it.isText }, { it.count }))
        val rates = strays.map { it.baud }.joinToString(" and ", postfix = " baud")
        return ProbedBoard(if (telling.count > 0) "no message at $rates; ${telling.inWords()}" else "no answer at $rates", answers = false)
    }

    /** Probes a board without a serial line, such as a ROS robot. */
    private fun elsewhere(name: String, provider: BoardLinkProvider): ProbedBoard =
        provider.open(name, true, LineClock.system()).use { link ->
            val description = if (describes) LinkDescription.of(link) else null
            ProbedBoard("a board that is reached over ${provider.scheme}", answers = true, description = description)
        }

    /** Probes the port [name] at [rate]. Without an answer, adds the received bytes to [strays] and returns null. */
    private fun at(name: String, rate: Int, strays: MutableList<StrayBytes>): ProbedBoard? =
        Link.open(name, LinkSettings.defaults().withBaud(rate).withProtocol(Protocol.AUTO), "argo ports").use { link ->
            try {
                found(link)
            } catch (_: PortTimeoutException) {
                strays += link.strayBytes()
                null
            }
        }

    private fun found(link: Link): ProbedBoard {
        if (describes) return BoardDescription.of(link).let { ProbedBoard(it.lines().first(), answers = true, description = it) }
        link.request(PerceptsRequest.ALL, ANSWER_MS).text()
        val baud = link.settings().line().baud()
        val rate = if (baud == USUAL.first()) "" else " at $baud baud"
        return ProbedBoard("a Javino board of ${versionSpoken(link.protocol())}$rate", answers = true)
    }

    companion object {
        /** The usual rates of sketches, the most common first. */
        val USUAL = listOf(9600, 115200, 57600)
        private val SCHEMES = listOf("sim:", "replay:", "tcp:")
        private const val ANSWER_MS = 1_000
    }
}
