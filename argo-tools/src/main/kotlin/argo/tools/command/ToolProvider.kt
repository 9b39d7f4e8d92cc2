package argo.tools.command

/**
 * Adds a command to the tools. [java.util.ServiceLoader] finds it: a class with a public constructor without arguments, named in
 * `META-INF/services/argo.tools.command.ToolProvider`.
 */
interface ToolProvider {
    /** Makes a command for picocli: a `Callable<Int>` whose result is the exit status. */
    fun command(): Any
}
