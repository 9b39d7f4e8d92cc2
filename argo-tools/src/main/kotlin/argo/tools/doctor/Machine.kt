package argo.tools.doctor

import javino.PortException
import javino.serial.SerialPorts
import javino.sim.PseudoTerminals
import java.io.IOException
import java.util.concurrent.TimeUnit

/** What can be known of the machine that this runs on. */
internal interface Machine {
    /** As Java calls the operating system: `Linux`, `Mac OS X`, `Windows 11`. */
    val system: String

    /** Java's feature version, such as 17. */
    val java: Int

    /** Java's version in full. */
    val javaInFull: String

    val user: String

    /** The user's groups in this login; null where that cannot be told. */
    val groups: List<String>?

    /** The names of the programs that run, without their folders. */
    val processes: Set<String>

    val hasSocat: Boolean

    /** The serial devices; the failure says why the driver cannot run. */
    fun ports(): Result<List<Device>>
}

/**
 * A serial device.
 *
 * @property isUsb whether it is known to be on USB, as boards are
 * @property remedy what this user can do to be allowed to open it; null: nothing is needed
 * @property holders the programs that have it open
 */
internal data class Device(val name: String, val isUsb: Boolean, val remedy: String?, val holders: List<String>)

/** The machine itself. */
internal object ThisMachine : Machine {
    private const val COMMAND_LIMIT_S = 10L

    override val system: String get() = System.getProperty("os.name", "")
    override val java: Int get() = Runtime.version().feature()
    override val javaInFull: String get() = "${Runtime.version()} (${System.getProperty("java.home")})"
    override val user: String get() = System.getProperty("user.name", "")
    override val groups: List<String>? get() = said("id", "-Gn")?.split(Regex("\\s+"))
    override val hasSocat: Boolean get() = PseudoTerminals.available()

    override val processes: Set<String>
        get() = ProcessHandle.allProcesses().iterator().asSequence()
            .mapNotNull { it.info().command().orElse(null) }.map { it.substringAfterLast('/').substringAfterLast('\\') }.toSet()

    override fun ports(): Result<List<Device>> = try {
        Result.success(
            SerialPorts.list().map { port ->
                Device(port.name(), port.vendorId().isPresent, SerialPorts.permissionRemedy(port.name()).orElse(null), SerialPorts.holders(port.name()))
            },
        )
    } catch (trouble: PortException) {
        Result.failure(trouble)
    }

    /** What a program prints; null if there is none, or it fails. */
    private fun said(vararg command: String): String? = try {
        val process = ProcessBuilder(*command).redirectError(ProcessBuilder.Redirect.DISCARD).start()
        val text = process.inputStream.bufferedReader().readText().trim()
        text.takeIf { process.waitFor(COMMAND_LIMIT_S, TimeUnit.SECONDS) && process.exitValue() == 0 }
    } catch (_: IOException) {
        null
    }
}
