package samples.firmware

import io.kotest.core.test.Enabled
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isExecutable

internal fun onPathOrNull(program: String): Path? =
    System.getenv("PATH").orEmpty().split(':').map { Path.of(it, program) }.find { it.isExecutable() }

internal fun onPath(program: String) = onPathOrNull(program) != null

/** Enables a test if this machine can compile a sketch for an Uno and run it. */
internal fun ifUnoCanBeSimulated(): Enabled =
    if (onPath("avr-gcc") && Path.of("/usr/include/simavr/sim_avr.h").exists()) Enabled.enabled
    else Enabled.disabled("there is no avr-gcc or no simavr, which \"./argo firmware\" installs")

internal fun tool(vararg command: String): String {
    val java = listOf("java", "-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC", "-jar", System.getProperty("argo.jar"))
    val process = ProcessBuilder(java + command).redirectErrorStream(true).start()
    return process.inputStream.readBytes().decodeToString().also { process.waitFor() }
}
