package argo.tools.doctor

import argo.tools.board.ProbedBoard
import argo.tools.doctor.Finding.Level.GOOD
import argo.tools.doctor.Finding.Level.PROBLEM
import argo.tools.doctor.Finding.Level.WARNING

/** Checks a computer for the common reasons why boards cannot be reached. */
internal class Examination(private val machine: Machine) {
    private val linux = machine.system.startsWith("Linux")
    private val windows = machine.system.startsWith("Windows")

    /** Makes all checks and returns their results. With [probe], also probes boards. [probe] gets the name of a port. */
    fun findings(probe: ((String) -> ProbedBoard)? = null): List<Finding> =
        listOf(java()) + boards(probe) + listOfNotNull(modemManager(), brltty(), socat())

    private fun java(): Finding {
        val found = "Java is ${machine.javaInFull}"
        return when {
            machine.java < MIN_JAVA -> Finding(PROBLEM, found, "ARGO needs 17 or newer: https://adoptium.net")
            machine.java < MIN_NEW_JASON_JAVA -> Finding(GOOD, "$found: enough for Jason 3.2.1; Jason 3.3.0 needs 21")
            else -> Finding(GOOD, "$found: enough for Jason 3.2.1 and 3.3.0")
        }
    }

    private fun boards(probe: ((String) -> ProbedBoard)?): List<Finding> = machine.ports().fold(
        onSuccess = { devices ->
            val driver = Finding(GOOD, "the serial driver's native library runs")
            val free = devices.filter { it.isUsb && it.remedy == null && it.holders.isEmpty() }
            listOfNotNull(driver, presence(devices), group(devices)) + devices.flatMap(::device) +
                free.mapNotNull { device -> probe?.let { probed(device, it(device.name)) } }
        },
        onFailure = { listOf(Finding(PROBLEM, "the serial driver does not run: ${it.message}", "see the message")) },
    )

    private fun presence(devices: List<Device>): Finding? = when {
        devices.any { it.isUsb } -> null
        devices.isEmpty() -> Finding(WARNING, "there is no serial port", noBoard())
        else -> Finding(WARNING, "no serial port is on USB: ${devices.joinToString { it.name }}", noBoard())
    }

    private fun noBoard(): String = "plug the board in, with a cable that carries data and not only power" + when {
        windows -> "; if the Device Manager shows it with a question mark, it needs a driver (CH340, CP210x, FTDI)"
        linux -> "; \"sudo dmesg | tail\" shows whether the machine detects it"
        else -> ""
    }

    /** Checks the groups of the user in this login. A change of groups takes effect at the next login. */
    private fun group(devices: List<Device>): Finding? {
        val groups = machine.groups
        if (!linux || groups == null || machine.user == "root") return null
        val serial = groups.filter { it in SERIAL_GROUPS }
        return when {
            serial.isNotEmpty() -> Finding(GOOD, "user ${machine.user} is in the group ${serial.joinToString()}")
            devices.isNotEmpty() && devices.all { it.remedy == null } -> null
            else -> Finding(
                PROBLEM, "user ${machine.user} is in none of the groups that usually own serial ports (${SERIAL_GROUPS.joinToString()})",
                "\"sudo usermod -aG dialout \$USER\" (on Arch uucp in place of dialout), then log out and in again",
            )
        }
    }

    private fun device(device: Device): List<Finding> {
        val level = if (device.isUsb) PROBLEM else WARNING
        val permission = device.remedy?.let { Finding(level, "user ${machine.user} may not open ${device.name}", it) }
        val holder = device.holders.takeIf { it.isNotEmpty() }?.let {
            val what = "${device.name} is held by ${it.joinToString(" and ")}"
            Finding(level, what, "end that program, or close the port there (as in the Serial Monitor)")
        }
        val free = Finding(GOOD, "${device.name} is free, and its permissions allow opening it")
        return listOfNotNull(permission, holder).ifEmpty { listOf(free) }
    }

    private fun probed(device: Device, board: ProbedBoard): Finding =
        if (board.answers == true) Finding(GOOD, "${device.name}: ${board.result}")
        else Finding(
            PROBLEM, "${device.name}: ${board.result}",
            "upload a sketch that uses the Javino library, with the rate of the agent's port in start(…); monitor --raw shows the bytes",
        )

    private fun modemManager(): Finding? = if (!linux || "ModemManager" !in machine.processes) null else Finding(
        WARNING, "ModemManager is running: it opens new serial ports and writes modem commands to boards for some seconds",
        "\"sudo systemctl disable --now ModemManager\", or a udev rule with ENV{ID_MM_DEVICE_IGNORE}=\"1\" for the board",
    )

    private fun brltty(): Finding? = if (!linux || "brltty" !in machine.processes) null else Finding(
        WARNING, "brltty is running: it takes USB serial chips such as the CH340 for braille displays, and their port disappears",
        "if nobody needs braille here: \"sudo apt remove brltty\"",
    )

    private fun socat(): Finding? = when {
        windows -> null
        machine.hasSocat -> Finding(GOOD, "socat is installed, for the command replay and for tests")
        else -> Finding(
            WARNING, "there is no socat, which the command replay and some tests need",
            if (linux) "\"sudo apt install socat\"" else "\"brew install socat\"",
        )
    }

    private companion object {
        const val MIN_JAVA = 17
        const val MIN_NEW_JASON_JAVA = 21
        val SERIAL_GROUPS = listOf("dialout", "uucp")
    }
}

internal data class Finding(val level: Level, val what: String, val remedy: String? = null) {
    enum class Level {
        GOOD,

        /** A function that only some users need may fail. */
        WARNING,

        /** Boards will not work. */
        PROBLEM,
    }
}
