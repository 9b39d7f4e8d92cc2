package argo.fleet

import argo.tools.command.filesOn
import argo.tools.command.refusingInWords
import picocli.CommandLine
import java.io.File
import java.lang.reflect.InvocationTargetException
import java.net.URL
import java.net.URLClassLoader
import kotlin.system.exitProcess

/**
 * Runs the agents of one computer of a fleet: `java -jar argo-fleet.jar robots.mas2j --at scout1`.
 *
 * This program's jar does not contain Jason. Jason is in another jar of its folder, or on `--class-path`. If Jason is not on the class
 * path, the program loads its own classes again together with Jason.
 */
fun main(arguments: Array<String>) {
    if (hasJason(FleetCommand::class.java.classLoader)) exitProcess(run(arguments))
    val loader = URLClassLoader(places(arguments).toTypedArray(), ClassLoader.getPlatformClassLoader())
    val wantsHelp = arguments.any { it == "-h" || it == "--help" }
    if (!wantsHelp && !hasJason(loader)) {
        System.err.println(
            "a fleet runs Jason, which argo-fleet.jar does not hold: put jason-interpreter.jar and its libraries into the folder of " +
                "argo-fleet.jar, or name them, as --class-path 'lib/*'",
        )
        exitProcess(1)
    }
    if (wantsHelp) exitProcess(run(arguments))
    Thread.currentThread().contextClassLoader = loader
    try {
        loader.loadClass("argo.fleet.MainKt").getMethod("main", Array<String>::class.java).invoke(null, arguments)
    } catch (failed: InvocationTargetException) {
        throw failed.targetException
    }
}

private fun run(arguments: Array<String>): Int = try {
    CommandLine(FleetCommand()).refusingInWords("command").setCommandName("java -jar argo-fleet.jar").execute(*arguments)
} catch (missing: NoClassDefFoundError) {
    System.err.println(
        "Jason runs without a class that it needs, ${missing.message?.replace('/', '.')}: put all of Jason's libraries beside " +
            "jason-interpreter.jar, and name their folder, as --class-path 'lib/*'",
    )
    1
}

private fun hasJason(loader: ClassLoader): Boolean = try {
    Class.forName("jason.asSemantics.Agent", false, loader)
    true
} catch (_: ClassNotFoundException) {
    false
}

/** Returns the entries of this program's class path, the jars beside this program's jar, and the entries of `--class-path`. */
private fun places(arguments: Array<String>): List<URL> {
    val own = System.getProperty("java.class.path")
    val beside = File(FleetCommand::class.java.protectionDomain.codeSource.location.toURI()).parentFile
    val named = arguments.withIndex().firstNotNullOfOrNull { (place, argument) ->
        if (argument == FleetCommand.CLASS_PATH) arguments.getOrNull(place + 1)
        else argument.removePrefix("${FleetCommand.CLASS_PATH}=").takeIf { it != argument }
    }.orEmpty()
    return filesOn(listOf(own, "$beside/*", named).joinToString(File.pathSeparator)).map { it.toUri().toURL() }
}
