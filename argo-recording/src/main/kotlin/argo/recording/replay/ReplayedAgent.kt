package argo.recording.replay

import argo.Arch
import argo.boundary.Boundary
import argo.platform.Platform
import argo.recording.Cycle
import argo.recording.RecordedAgent
import jason.architecture.AgArch
import jason.asSemantics.Agent
import jason.asSemantics.TransitionSystem
import jason.asSyntax.directives.DirectiveProcessor
import jason.asSyntax.directives.Include
import jason.mas2j.ClassParameters
import jason.runtime.RuntimeServices
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import jason.runtime.SourcePath
import jason.util.Config
import java.nio.file.Path

/**
 * An agent of a recording, that Jason runs again on what was recorded: no ports, no threads, no time of its own.
 *
 * @param programs where its program stands
 * @param found takes what differs from the recording
 * @param inputsOf makes what gives it the recorded inputs
 * @param boundaryOf what stands around these inputs: themselves, or who watches
 */
internal class ReplayedAgent(
    val recorded: RecordedAgent,
    programs: ProgramFiles,
    private val found: (cycle: Cycle, what: String, recorded: String?, now: String?, cause: String) -> Unit = { _, _, _, _, _ -> },
    inputsOf: (DifferenceSink) -> ReplayedInputs = ::ReplayedInputs,
    private val boundaryOf: (ReplayedInputs) -> Boundary = { it },
) : AutoCloseable {
    private val inputs: ReplayedInputs = inputsOf { what, before, now, cause -> report(what, before, now, cause) }
    private val infra = Infra(recorded)
    val ts: TransitionSystem = create(programs.of(recorded.name), programs.directory)
    private var lastIndex = 0L

    private fun create(source: Path, directory: Path): TransitionSystem {
        listOf(recorded.agentClass, recorded.archClass, recorded.beliefBase).forEach(::requireClass)
        val paths = SourcePath().apply { listOfNotNull(source.parent, directory).forEach { addPath("$it") } }
        (DirectiveProcessor.getDirective("include") as Include).setSourcePath(paths)
        val settings = Settings().apply { setOptions(HashMap<String, Any>(recorded.options - RECORD)) }
        val beliefBase = recorded.beliefBase.takeIf { it != DEFAULT_BELIEFS }?.let { ClassParameters(it) }
        load { unshown { Agent.create(infra, recorded.agentClass, beliefBase, "$source", settings) } }
        val ts = infra.ts
        infra.insertAgArch(infra)
        val arch = Class.forName(recorded.archClass).asSubclass(Arch::class.java).getConstructor(Platform::class.java)
            .newInstance(ReplayPlatform(boundaryOf(inputs)))
        arch.ts = ts
        infra.insertAgArch(arch)
        arch.init()
        ts.logger.useParentHandlers = false // what it printed is in the recording
        inputs.begin(ts)
        return ts
    }

    private fun load(create: () -> Unit) = try {
        create()
    } catch (missing: LinkageError) {
        throw RecordingException("the program of agent ${recorded.name} cannot be loaded, since a class is missing or another: $missing")
    } catch (refused: Exception) { // Jason declares no other
        throw RecordingException("Jason cannot read the program of agent ${recorded.name}: ${refused.message}")
    }

    /** Without Jason's server that shows agents, which [create] would start. */
    private fun unshown(create: () -> Unit) {
        val config = Config.get()
        val before: Any? = config.setProperty(Config.START_WEB_MI, "false")
        try {
            create()
        } finally {
            if (before == null) config.remove(Config.START_WEB_MI) else config[Config.START_WEB_MI] = before
        }
    }

    private fun requireClass(name: String) {
        if (isThere(name)) return
        throw RecordingException(
            "agent ${recorded.name} needs the class $name, which is not on the class path; add the classes and jars of its project to it",
        )
    }

    private fun isThere(type: String) = try {
        Class.forName(type, false, javaClass.classLoader)
        true
    } catch (_: ClassNotFoundException) {
        false
    }

    /** Runs [cycle], the next one of the recording. */
    fun run(cycle: Cycle) {
        if (cycle.index != lastIndex + 1) throw RecordingException(gap(cycle))
        lastIndex = cycle.index
        reason(cycle)
        difference(cycle.course, inputs.course.end())?.let { (what, before, now) -> report(what, before, now, null) }
    }

    /** Runs [cycle], which is not of the recording. */
    fun runBetween(cycle: Cycle) {
        reason(cycle)
        inputs.course.end()
    }

    private fun reason(cycle: Cycle) {
        inputs.next(cycle)
        val first = ts.agArch
        first.cycleNumber = cycle.number
        first.reasoningCycleStarting()
        ts.sense()
        if (!recorded.isConditional || !ts.canSleepDeliberate()) ts.deliberate()
        if (!recorded.isConditional || !ts.canSleepAct()) ts.act()
        first.reasoningCycleFinished()
    }

    private fun gap(cycle: Cycle) =
        if (lastIndex == 0L) {
            "the recording of agent ${recorded.name} begins with its cycle ${cycle.index}, and what it believed then is not known; " +
                "only a recording from the beginning on, argo_record=\"FILE.mcap\", can be replayed"
        } else {
            "the recording of agent ${recorded.name} has a gap of ${cycle.index - lastIndex - 1} cycles before cycle ${cycle.number}: " +
                "the disk was too slow, or that part of the file is damaged; until there it can be replayed"
        }

    private fun report(what: String, before: String?, now: String?, cause: String?): Unit =
        found(inputs.cycle, what, before, now, cause ?: likelyCause())

    private fun likelyCause(): String = missingAction()?.let { "the project's class $it is not on the class path; add it" } ?: when {
        inputs.cycle.input.events.isNotEmpty() || inputs.cycle.input.ends.any { it.thread != null } ->
            "another thread of the project works on the agent, and what it does within a cycle is not recorded"
        recorded.agentClass != Agent::class.java.name ->
            "the agent's class ${recorded.agentClass} chooses or believes by what is not recorded"
        recorded.beliefBase != DEFAULT_BELIEFS -> "the belief base ${recorded.beliefBase} depends on what is not recorded"
        inputs.projectCalls.isNotEmpty() ->
            "what the project's own ${inputs.projectCalls.joinToString()} does besides its result is not recorded; " +
                "neither is what other threads of the project do"
        else -> "a thread of the project has changed what the agent believes or intends, or its program is another"
    }

    private fun missingAction(): String? = inputs.cycle.input.calls.filter { it.isOfProject }.map { it.name }.find { !isThere(it) }

    override fun close() {
        inputs.course.close()
        ts.logger.useParentHandlers = true
        ts.ag.stopAg()
        ts.agArch.stop()
    }

    private class Infra(private val recorded: RecordedAgent) : AgArch() {
        override fun getAgName() = recorded.name

        @Suppress("OVERRIDE_DEPRECATION") // where Jason 3.3 asks for some services
        override fun getRuntimeServices(): RuntimeServices? = RuntimeServicesFactory.get()
    }

    private companion object {
        const val RECORD = "argo_record"
        const val DEFAULT_BELIEFS = "jason.bb.DefaultBeliefBase"
    }
}
