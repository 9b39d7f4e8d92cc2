package argo.tools.replay

import argo.tools.command.DataCommand
import argo.tools.command.QUICK_START
import argo.tools.command.ToolException
import argo.tools.command.classPathWithJason
import argo.tools.command.hasJason
import argo.tools.command.missingJason
import argo.tools.command.runJava
import argo.tools.command.tellAbsent
import picocli.CommandLine.Command
import picocli.CommandLine.Option

/** A tool that runs Jason. The tool runs in this program if Jason and all other classes are there, and otherwise in another program. */
@Command
internal abstract class JasonCommand : DataCommand() {
    @Option(names = [CLASS_PATH], paramLabel = "PATH", description = ["the project's classes and jars, and Jason's, as for java -cp"])
    protected var classPath: String? = null

    /** True if this program can run the tool itself. */
    protected val runsHere: Boolean get() = classPath == null && hasJason()

    /**
     * Runs this tool in another program with these options and with [operands]. Returns its exit status.
     *
     * @throws ToolException if there is no Jason
     */
    protected fun runElsewhere(vararg operands: String): Int {
        tellAbsent(classPath, err)
        val path = classPathWithJason(classPath) ?: throw ToolException(missingJason())
        val program = QUICK_START + listOf("-Dargo.command=${spec.root().name()}", "-cp", path, "argo.tools.MainKt", spec.name())
        return runJava(program + givenWithout(CLASS_PATH) + "--" + operands)
    }

    /** Tells the user that properties for agents have no effect, since recorded agents have the recorded options. */
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
