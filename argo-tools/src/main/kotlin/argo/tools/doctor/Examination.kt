package argo.tools.doctor

import argo.tools.doctor.Finding.Level.GOOD
import argo.tools.doctor.Finding.Level.PROBLEM
import argo.tools.doctor.Finding.Level.WARNING

/** Looks at everything that has kept somebody from a board. */
internal class Examination(private val machine: Machine) {
    private val linux = machine.system.startsWith("Linux")
    private val windows = machine.system.startsWith("Windows")

    fun findings(): List<Finding> = listOf(java()) + boards() + listOfNotNull(modemManager(), brltty(), socat())

    private fun java(): Finding = when {
        machine.java < LEAST_JAVA ->
            Finding(PROBLEM, "Java is ${machine.javaInFull}", "ARGO needs 17 or newer: https://adoptium.net")
        machine.java < NEW_JASON_JAVA -> Finding(GOOD, "Java is ${machine.javaInFull}: enough for Jason 3.2.1; Jason 3.3.0 needs 21")
        else -> Finding(GOOD, "Java is ${machine.javaInFull}: enough for Jason 3.2.1 and 3.3.0")
    }

    private fun boards(): List<Finding> = machine.ports().fold(
        onSuccess = { devices -> listOf(Finding(GOOD, "the serial driver's native library runs")) + listOfNotNull(presence(devices), group(devices)) + devices.flatMap(::device) },
        onFailure = { listOf(Finding(PROBLEM, "the serial driver does not run: ${it.message}", "see the message")) },
    )

    private fun presence(devices: List<Device>): Finding? = when {
        devices.any { it.isUsb } -> null
        devices.isEmpty() -> Finding(WARNING, "there is no serial port", noBoard())
        else -> Finding(WARNING, "no serial port is on USB: ${devices.joinToString { it.name }}", noBoard())
    }

    private fun noBoard(): String = "plug the board in, with a cable that carries data and not only power" + when {
        windows -> "; if the Device Manager shows it with a question mark, it needs a driver (CH340, CP210x, FTDI)"
        linux -> "; \"sudo dmesg | tail\" says whether the machine sees it"
        else -> ""
    }

    /** A login is as old as its groups: who has just been added to one is in it from the next login on. */
    private fun group(devices: List<Device>): Finding? {
        val groups = machine.groups
        if (!linux || groups == null || machine.user == "root") return null
        val serial = groups.filter { it in SERIAL_GROUPS }
        return when {
            serial.isNotEmpty() -> Finding(GOOD, "user ${machine.user} is in the group ${serial.joinToString()}")
            devices.none { it.remedy != null } && devices.isNotEmpty() -> null
            else -> Finding(
                PROBLEM, "user ${machine.user} is in none of the groups that serial ports usually belong to (${SERIAL_GROUPS.joinToString()})",
                "\"sudo usermod -aG dialout \$USER\" (on Arch uucp in place of dialout), then log out and in again",
            )
        }
    }

    private fun device(device: Device): List<Finding> {
        val permission = if (device.remedy == null) null else Finding(if (device.isUsb) PROBLEM else WARNING, "user ${machine.user} may not open ${device.name}", device.remedy)
        val holder = if (device.holders.isEmpty()) null else Finding(
            if (device.isUsb) PROBLEM else WARNING, "${device.name} is held by ${device.holders.joinToString(" and ")}", "end that program, or close the port there (the Serial Monitor, say)",
        )
        val free = if (permission == null && holder == null) Finding(GOOD, "${device.name} can be opened, as far as can be told without doing it") else null
        return listOfNotNull(permission, holder, free)
    }

    private fun modemManager(): Finding? = if (!linux || "ModemManager" !in machine.processes) null else Finding(
        WARNING, "ModemManager is running: it opens new serial ports and writes modem commands to boards for some seconds after they are plugged in",
        "\"sudo systemctl disable --now ModemManager\", or a udev rule with ENV{ID_MM_DEVICE_IGNORE}=\"1\" for the board",
    )

    private fun brltty(): Finding? = if (!linux || "brltty" !in machine.processes) null else Finding(
        WARNING, "brltty is running: it takes USB serial chips such as the CH340 for braille displays, and their port disappears",
        "if nobody reads braille here: \"sudo apt remove brltty\"",
    )

    private fun socat(): Finding? = when {
        windows -> null
        machine.hasSocat -> Finding(GOOD, "socat is there, for the command replay and for tests")
        else -> Finding(WARNING, "there is no socat, which the command replay and some tests need", if (linux) "\"sudo apt install socat\"" else "\"brew install socat\"")
    }

    private companion object {
        const val LEAST_JAVA = 17
        const val NEW_JASON_JAVA = 21
        val SERIAL_GROUPS = listOf("dialout", "uucp")
    }
}
