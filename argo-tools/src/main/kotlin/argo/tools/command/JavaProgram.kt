package argo.tools.command

import java.nio.file.Path

/**
 * Runs this program's Java with [arguments] on the same terminal, and returns its exit status. If this program ends, the started program
 * ends too.
 */
internal fun runJava(arguments: List<String>): Int = java(arguments).inheritIO().start().awaitEnd()

/** Returns a builder that starts this program's Java with [arguments]. */
internal fun java(arguments: List<String>): ProcessBuilder {
    val java = ProcessHandle.current().info().command().orElseGet { Path.of(System.getProperty("java.home"), "bin", "java").toString() }
    // jSerialComm loads a native library, and newer Java machines warn about that without this option
    return ProcessBuilder(listOf(java, "--enable-native-access=ALL-UNNAMED") + arguments)
}

/** Waits until this process has ended, and returns its exit status. If this program ends first, it ends the process too. */
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
