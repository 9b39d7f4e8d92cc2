package argo.tools.command

import java.nio.file.Path

/**
 * Runs Java with [arguments] on this terminal, and returns the exit status. Uses the Java installation of this program. The started program
 * ends with this program.
 */
internal fun runJava(arguments: List<String>): Int = java(arguments).inheritIO().start().awaitEnd()

internal fun java(arguments: List<String>): ProcessBuilder {
    val java = ProcessHandle.current().info().command().orElseGet { Path.of(System.getProperty("java.home"), "bin", "java").toString() }
    // jSerialComm loads a native library; without this option newer Java versions print a warning
    return ProcessBuilder(listOf(java, "--enable-native-access=ALL-UNNAMED") + arguments)
}

/** Waits for the end of this process, and returns its exit status. If this program ends first, the process is ended too. */
internal fun Process.awaitEnd(): Int {
    val ending = Thread {
        destroy()
        waitFor()
    }
    val runtime = Runtime.getRuntime()
    runtime.addShutdownHook(ending)
    return waitFor().also {
        try {
            runtime.removeShutdownHook(ending)
        } catch (_: IllegalStateException) {
            // this program is ending
        }
    }
}
