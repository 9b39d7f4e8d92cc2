package argo.tools.board

import argo.tools.command.ExitStatus
import argo.tools.command.ToolCommand
import argo.tools.command.printable
import argo.tools.command.requireWithin
import javino.Link
import javino.LinkSettings
import javino.NoSuchPortException
import javino.PerceptsRequest
import javino.PortException
import javino.PortTimeoutException
import javino.Protocol
import javino.serial.SerialPortInfo
import javino.serial.SerialPorts
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.util.Optional
import java.util.OptionalInt

/** `ports`: the serial ports there are. */
@Command(
    name = "ports",
    description = ["Lists the serial ports: what is plugged in, who holds it, and with --probe whether a Javino board answers there."],
)
internal class PortsCommand : ToolCommand() {
    @Parameters(arity = "0..*", paramLabel = "PORT", description = ["these ports in place of all; also pseudo-terminals by their path"])
    private var names: List<String> = emptyList()

    @Option(names = ["--probe"], description = ["asks each port that is free for its percepts. Opening a port resets most boards, and motors may jerk"])
    private var probe = false

    @Option(names = ["--baud"], paramLabel = "RATE", defaultValue = "9600", description = ["the rate to probe at (\${DEFAULT-VALUE})"])
    private var baud = 0

    @Option(names = ["--json"], description = ["prints an array of objects of JSON"])
    private var json = false

    override fun call(): Int {
        spec.requireWithin("--baud", baud, LineOptions.BAUDS)
        val rows = ports().map { Row(it, SerialPorts.holders(it.name())) }
        val probed = rows.map { if (probe) it.copy(board = board(it)) else it }
        if (json) out.println(JsonArray(probed.map(Row::json))) else print(probed)
        return if (probed.any { it.board?.isMissing == true }) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun ports(): List<SerialPortInfo> {
        val present = SerialPorts.list()
        if (names.isEmpty()) return present
        return names.map { name -> present.find { name == it.name() || name == it.path() } ?: unlisted(name) }
    }

    /** A port that the system does not list: a pseudo-terminal, a simulated board, or none. */
    private fun unlisted(name: String) =
        SerialPortInfo(name, name, Optional.empty(), Optional.empty(), OptionalInt.empty(), OptionalInt.empty(), Optional.empty())

    private fun board(row: Row): Board {
        if (row.holders.isNotEmpty()) return Board("not asked, since it is in use", answers = null)
        val settings = LinkSettings.defaults().withBaud(baud).withProtocol(Protocol.AUTO)
        return try {
            Link.open(row.info.name(), settings, "argo ports").use { link ->
                link.request(PerceptsRequest.ALL, PROBE_MS).text()
                Board("a Javino board of ${versionSpoken(link.protocol())}", answers = true)
            }
        } catch (_: PortTimeoutException) {
            Board("no answer at $baud baud", answers = false)
        } catch (missing: NoSuchPortException) {
            Board(missing.message.orEmpty(), answers = false, isMissing = true)
        } catch (trouble: PortException) {
            Board(trouble.message.orEmpty(), answers = null)
        }
    }

    private fun print(rows: List<Row>) {
        if (rows.isEmpty()) return out.println("there are no serial ports; is the board plugged in, with a cable that carries data?")
        val table = rows.map { row -> listOf(row.info.name(), row.usb ?: "-", row.info.serialNumber().orElse("-"), row.product, row.holders.joinToString().ifEmpty { "-" }) + listOfNotNull(row.board?.said) }
        val head = listOf("PORT", "USB", "SERIAL", "PRODUCT", "HELD BY") + if (probe) listOf("BOARD") else emptyList()
        val widths = head.indices.map { column -> (table + listOf(head)).maxOf { printable(it[column]).length } }
        (listOf(head) + table).forEach { line -> out.println(line.mapIndexed { column, text -> printable(text).padEnd(widths[column]) }.joinToString("  ").trimEnd()) }
    }

    private companion object {
        const val PROBE_MS = 1_000
    }
}

/**
 * What asking a port for percepts brought.
 *
 * @property answers null: not known
 */
private data class Board(val said: String, val answers: Boolean?, val isMissing: Boolean = false)

private data class Row(val info: SerialPortInfo, val holders: List<String>, val board: Board? = null) {
    val usb: String? = if (info.vendorId().isPresent && info.productId().isPresent) "%04x:%04x".format(info.vendorId().asInt, info.productId().asInt) else null

    val product: String = listOfNotNull(info.product().orElse(null), info.manufacturer().orElse(null)?.let { "($it)" }).joinToString(" ").ifEmpty { "-" }

    fun json(): JsonObject = buildJsonObject {
        put("port", info.name())
        put("path", info.path())
        put("usb", usb)
        put("serial", info.serialNumber().orElse(null))
        put("product", info.product().orElse(null))
        put("manufacturer", info.manufacturer().orElse(null))
        put("heldBy", JsonArray(holders.map(::JsonPrimitive)))
        if (board != null) {
            put("board", board.said)
            put("answers", board.answers)
        }
    }
}
