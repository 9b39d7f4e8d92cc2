package argo.tools.command

/**
 * Adds a command to the tools. [java.util.ServiceLoader] finds the class by the file `META-INF/services/argo.tools.command.ToolProvider`.
 * The class needs a public constructor without arguments.
 */
interface ToolProvider {
    /** Makes a command for picocli: a `Callable<Int>` whose result is the exit status. */
    fun command(): Any
}
