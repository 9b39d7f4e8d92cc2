package argo.tools.board

import argo.filters.withControlsShown
import argo.tools.command.DataCommand
import argo.tools.command.ExitStatus
import argo.tools.command.jsonArrayOf
import argo.tools.command.jsonOf
import argo.tools.command.requireWithin
import argo.tools.command.table
import javino.serial.SerialPortInfo
import javino.serial.SerialPorts
import kotlinx.serialization.json.JsonObject
import picocli.CommandLine.Command
import picocli.CommandLine.Option
import picocli.CommandLine.Parameters
import java.io.IOException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import java.nio.file.attribute.BasicFileAttributes
import java.util.Optional
import java.util.OptionalInt

@Command(
    name = "ports",
    description = [
        "Lists the serial ports with their devices and owners; with --probe whether a board answers there, with --describe what it can do.",
    ],
)
internal class PortsCommand : DataCommand() {
    @Parameters(arity = "0..*", paramLabel = "PORT", description = ["these ports in place of all; also pseudo-terminals by their path"])
    private var names: List<String> = emptyList()

    @Option(names = ["--probe"], description = ["requests percepts at each free port. Opening it resets most boards; motors may jerk"])
    private var probe = false

    @Option(
        names = ["--describe"],
        description = [
            "as --probe, and asks each board for its actions and the kinds of its percepts, with units and ranges; prints them with its " +
                "percepts and how many critical rules it holds",
        ],
    )
    private var describe = false

    @Option(names = ["--baud"], paramLabel = "RATE", description = ["the rate to probe at (9600, 115200 and 57600 in turn)"])
    private var baud: Int? = null

    override fun call(): Int {
        baud?.let { spec.requireWithin("--baud", it, LineOptions.BAUDS) }
        names.find { ':' in it && !probe && !describe }?.let {
            misuse("$it is no serial port, and nothing is known of it before it is opened; \"ports --probe $it\" does that")
        }
        val (missing, ports) = ports().partition { !probe && !describe && isMissing(it.path()) }
        missing.forEach {
            val name = withControlsShown(it.name()).ifEmpty { "without a name" }
            err.println(paint.bad("there is no port $name; there are: ${present()}"))
        }
        val rows = ports.map { Row(it, SerialPorts.holders(it.name())) }
        val probed = rows.map { if (probe || describe) it.copy(board = board(it)) else it }
        when {
            json -> out.println(jsonArrayOf(probed.map(Row::json)))
            describe && rows.isNotEmpty() -> probed.forEach(::describe)
            missing.isEmpty() || probed.isNotEmpty() -> print(probed)
        }
        return if (missing.isNotEmpty() || probed.any { it.board?.isMissing == true }) ExitStatus.FAILED else ExitStatus.DONE
    }

    private fun present() = SerialPorts.list().joinToString { it.name() }.ifEmpty { "none" }

    private fun isMissing(path: String) = SerialPorts.list().none { it.path() == path } && listOf(path, "/dev/$path").none(::isDevice)

    private fun isDevice(path: String) = try {
        Files.readAttributes(Path.of(path), BasicFileAttributes::class.java).isOther
    } catch (_: IOException) {
        false
    } catch (_: InvalidPathException) {
        false
    }

    private fun ports(): List<SerialPortInfo> {
        val present = SerialPorts.list()
        if (names.isEmpty()) return present
        return names.map { name -> present.find { name == it.name() || name == it.path() } ?: unlisted(name) }
    }

    /** Describes a port that the operating system does not list: a pseudo-terminal, a simulated board or a missing port. */
    private fun unlisted(name: String) =
        SerialPortInfo(name, name, Optional.empty(), Optional.empty(), OptionalInt.empty(), OptionalInt.empty(), Optional.empty())

    private fun board(row: Row): ProbedBoard {
        if (row.holders.isNotEmpty()) return ProbedBoard("not probed, because it is in use", answers = null)
        return Probe(baud?.let(::listOf) ?: Probe.USUAL, describe).of(row.info.name())
    }

    private fun describe(row: Row) {
        val lines = row.board?.description?.lines() ?: listOf(withControlsShown(row.board?.result.orEmpty()))
        out.println("${withControlsShown(row.info.name())}: ${lines.first()}")
        lines.drop(1).forEach { out.println("  $it") }
    }

    private fun print(rows: List<Row>) {
        if (rows.isEmpty()) return out.println("there are no serial ports; is the board plugged in, with a cable that carries data?")
        val head = listOf("PORT", "USB", "SERIAL", "PRODUCT", "HELD BY") + if (probe) listOf("BOARD") else emptyList()
        table(head, rows.map { row -> row.cells().map(::withControlsShown) }).forEach(out::println)
    }
}

private data class Row(val info: SerialPortInfo, val holders: List<String>, val board: ProbedBoard? = null) {
    private val usb: String? = if (info.vendorId().isEmpty || info.productId().isEmpty) null
    else "%04x:%04x".format(info.vendorId().asInt, info.productId().asInt)

    fun cells(): List<String> {
        val product = listOfNotNull(info.product().orElse(null), info.manufacturer().orElse(null)?.let { "($it)" }).joinToString(" ")
        val cells = listOf(info.name(), usb.orEmpty(), info.serialNumber().orElse(""), product, holders.joinToString())
        return cells.map { it.ifEmpty { "-" } } + listOfNotNull(board?.result)
    }

    fun json(): JsonObject {
        val members = mapOf(
            "port" to info.name(), "path" to info.path(), "usb" to usb, "serial" to info.serialNumber().orElse(null),
            "product" to info.product().orElse(null), "manufacturer" to info.manufacturer().orElse(null), "heldBy" to holders,
        )
        val probed = board?.let { mapOf("board" to it.result, "answers" to it.answers) }.orEmpty()
        return jsonOf(*(members + probed + board?.description?.members().orEmpty()).toList().toTypedArray())
    }
}
