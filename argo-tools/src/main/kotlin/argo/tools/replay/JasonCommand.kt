package argo.tools.replay

import argo.tools.command.DataCommand
import argo.tools.command.ToolException
import argo.tools.command.runJava
import picocli.CommandLine.Command
import picocli.CommandLine.Option

/** A tool that runs Jason: in another program, unless this one has Jason and everything else that the tool needs. */
@Command
internal abstract class JasonCommand : DataCommand() {
    @Option(names = [CLASS_PATH], paramLabel = "PATH", description = ["the project's classes and jars, and Jason's, as for java -cp"])
    protected var classPath: String? = null

    /** True if this program can run the tool itself. */
    protected val runsHere: Boolean get() = classPath == null && hasJason()

    /**
     * Runs this tool with its options and [operands] in another program, and returns that program's exit status.
     *
     * @throws ToolException if there is no Jason
     */
    protected fun runElsewhere(vararg operands: String): Int {
        tellAbsent(classPath, err)
        val path = classPathWithJason(classPath) ?: throw ToolException(missingJason())
        val program = QUICK_START + listOf("-Dargo.command=${spec.root().name()}", "-cp", path, "argo.tools.MainKt", spec.name())
        return runJava(program + givenWithout(CLASS_PATH) + "--" + operands)
    }

    /** Tells the user that agents in a recording have the recorded options, and not those among this program's properties. */
    protected fun tellUnusedOptions() {
        val unused = System.getProperties().stringPropertyNames().filter { it.startsWith("argo_") }.sorted()
        if (unused.isEmpty()) return
        val have = if (unused.size == 1) "has" else "have"
        err.println("${unused.joinToString { "-D$it" }} $have no effect: the agents have recorded options")
    }

    private companion object {
        const val CLASS_PATH = "--class-path"
    }
}
