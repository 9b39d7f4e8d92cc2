package argo.tools.doctor

import javino.PortException
import javino.serial.SerialPorts
import javino.sim.PseudoTerminals
import java.io.IOException
import java.util.concurrent.TimeUnit

/** The facts about a computer that matter for boards. */
internal interface Machine {
    /** The operating system in Java's words, such as `Linux`, `Mac OS X` or `Windows 11`. */
    val system: String

    val java: Int

    val javaInFull: String

    val user: String

    /** The user's groups in this login, or null if they are unknown. */
    val groups: List<String>?

    val processes: Set<String>

    val hasSocat: Boolean

    /** Returns the serial devices, or the reason why the driver does not work. */
    fun ports(): Result<List<Device>>
}

/**
 * A serial device.
 *
 * @property isUsb true for a USB device, as boards are
 * @property remedy advice for getting permission to open the device, or null if the user has permission
 * @property holders the programs that have opened the device
 */
internal data class Device(val name: String, val isUsb: Boolean, val remedy: String?, val holders: List<String>)

internal object ThisMachine : Machine {
    private const val COMMAND_LIMIT_S = 10L

    override val system: String get() = System.getProperty("os.name", "")
    override val java: Int get() = Runtime.version().feature()
    override val javaInFull: String get() = "${Runtime.version()} (${System.getProperty("java.home")})"
    override val user: String get() = System.getProperty("user.name", "")
    override val groups: List<String>? get() = output("id", "-Gn")?.split(Regex("\\s+"))
    override val hasSocat: Boolean get() = PseudoTerminals.available()

    override val processes: Set<String>
        get() = ProcessHandle.allProcesses().iterator().asSequence()
            .mapNotNull { it.info().command().orElse(null) }.map { it.substringAfterLast('/').substringAfterLast('\\') }.toSet()

    override fun ports(): Result<List<Device>> = try {
        Result.success(
            SerialPorts.list().map { port ->
                val name = port.name()
                Device(name, port.vendorId().isPresent, SerialPorts.permissionRemedy(name).orElse(null), SerialPorts.holders(name))
            },
        )
    } catch (trouble: PortException) {
        Result.failure(trouble)
    }

    private fun output(vararg command: String): String? = try {
        val process = ProcessBuilder(*command).redirectError(ProcessBuilder.Redirect.DISCARD).start()
        val text = process.inputStream.bufferedReader().readText().trim()
        text.takeIf { process.waitFor(COMMAND_LIMIT_S, TimeUnit.SECONDS) && process.exitValue() == 0 }
    } catch (_: IOException) {
        null
    }
}
