package argo.recording.replay

import argo.Arch
import argo.boundary.Boundary
import argo.platform.Platform
import argo.recording.RecordedAgent
import argo.recording.agent.Counters
import argo.recording.agent.Insides
import jason.architecture.AgArch
import jason.asSemantics.Agent
import jason.asSemantics.TransitionSystem
import jason.asSyntax.directives.DirectiveProcessor
import jason.asSyntax.directives.Include
import jason.asSyntax.parser.ParseException
import jason.bb.BeliefBase
import jason.bb.DefaultBeliefBase
import jason.mas2j.ClassParameters
import jason.runtime.RuntimeServices
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import jason.runtime.SourcePath
import jason.util.Config
import java.io.File
import java.net.MalformedURLException
import java.net.URL
import java.nio.file.Files
import java.nio.file.Path

/**
 * An agent as [recorded] was, made by Jason: no ports, no threads, no time of its own. All that enters it comes from [boundary].
 *
 * @param source its program
 * @param directory where included files are looked for, besides beside the program
 * @throws RecordingException if a class of it is missing, or Jason cannot read it
 */
internal fun jasonAgent(recorded: RecordedAgent, source: Path, directory: Path, boundary: Boundary): TransitionSystem {
    Config.get().putAll(recorded.config) // before Jason reads them, once in a program
    val classes = listOf(recorded.agentClass, recorded.archClass, recorded.beliefBase) + recorded.directives.values
    classes.forEach { requireClass(recorded, it) }
    recorded.directives.forEach { (name, type) -> DirectiveProcessor.registerDirective(name, Class.forName(type)) }
    val paths = SourcePath().apply { listOfNotNull(source.parent, directory).forEach { addPath("$it") } }
    (DirectiveProcessor.getDirective("include") as Include).setSourcePath(paths)
    val settings = Settings().apply { setOptions(HashMap<String, Any>(recorded.options - RECORD)) }
    val beliefBase = recorded.beliefBase.takeIf { it != DEFAULT_BELIEFS }?.let { ClassParameters(it) }
    val infra = Infra(recorded)
    val address = if (source == directory.resolve(recorded.source)) recorded.address else null
    recorded.firstLabel?.let(Counters::nameFrom)
    load(recorded) { unshown { create(infra, recorded.agentClass, beliefBase, settings) { ag -> ag.read(source, address) } } }
    val ts = infra.ts
    infra.insertAgArch(infra)
    val arch = Class.forName(recorded.archClass).asSubclass(Arch::class.java).getConstructor(Platform::class.java)
        .newInstance(ReplayPlatform(boundary))
    arch.ts = ts
    infra.insertAgArch(arch)
    arch.init()
    ts.logger.useParentHandlers = false // what it printed is in the recording
    return ts
}

/** As [Agent.create], which reads a program only where it lies. */
private fun create(infra: AgArch, type: String, beliefBase: ClassParameters?, settings: Settings, read: (Agent) -> Unit) {
    val agent = Class.forName(type).getConstructor().newInstance() as Agent
    TransitionSystem(agent, null, settings, infra)
    agent.bb = beliefBase?.let { Class.forName(it.className).getConstructor().newInstance() as BeliefBase } ?: DefaultBeliefBase()
    agent.initAg()
    beliefBase?.let { agent.bb.init(agent, it.parametersArray) }
    read(agent)
}

/** Reads the program in the file [source] as if it lay at [address], which Jason shows in annotations and errors; null: where it lies. */
private fun Agent.read(source: Path, address: String?) {
    if (address == null) return loadInitialAS("$source")
    Files.newInputStream(source).use { parseAS(it, shown(address)) }
    loadInitialAS(null) // the rest
    aslSrc = address
}

/** What Jason calls a program that it reads at [address]: the URL, or the name of a file. */
private fun shown(address: String) = try {
    "${URL(address)}"
} catch (_: MalformedURLException) {
    File(address).name
}

/** Has Jason forget what it forgets in so many [cycles] in which nothing happens, which are not recorded. */
internal fun TransitionSystem.rest(cycles: Int) {
    if (cycles <= 0) return
    c.resetDeliberate()
    c.resetAct()
    repeat(cycles) {
        val unperceived = Insides.cyclesUnperceived.getInt(this)
        Insides.cyclesUnperceived.setInt(this, if (unperceived >= settings.nrcbp()) 1 else unperceived + 1)
        if (settings.nrcbp() <= 1) return
    }
}

/** Carries out a reasoning cycle with this [number], of an agent that [isConditional] as [RecordedAgent.isConditional] has it. */
internal fun TransitionSystem.cycle(number: Int, isConditional: Boolean) {
    val first = agArch
    first.cycleNumber = number
    first.reasoningCycleStarting()
    sense()
    if (!isConditional || !canSleepDeliberate()) deliberate()
    if (!isConditional || !canSleepAct()) act()
    first.reasoningCycleFinished()
}

/** Ends the agent. */
internal fun TransitionSystem.end() {
    logger.useParentHandlers = true
    ag.stopAg()
    agArch.stop()
}

private fun load(recorded: RecordedAgent, create: () -> Unit) = try {
    create()
} catch (missing: LinkageError) {
    throw RecordingException("the program of agent ${recorded.name} cannot be loaded, since a class is missing or another: $missing")
} catch (refused: Exception) { // Jason declares no other
    val unreadable = generateSequence<Throwable>(refused) { it.cause }.firstNotNullOfOrNull { it as? ParseException }
    val why = unreadable?.let(::unreadableAt) ?: refused.message
    throw RecordingException("Jason cannot read the program of agent ${recorded.name}: $why")
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

private fun requireClass(recorded: RecordedAgent, name: String) {
    if (isThere(name)) return
    throw RecordingException(
        "agent ${recorded.name} needs the class $name, which is not on the class path; add the classes and jars of its project to it",
    )
}

/** Whether the class [type] is on the class path. */
internal fun isThere(type: String) = try {
    Class.forName(type, false, ReplayPlatform::class.java.classLoader)
    true
} catch (_: ClassNotFoundException) {
    false
}

private class Infra(private val recorded: RecordedAgent) : AgArch() {
    override fun getAgName() = recorded.name

    @Suppress("OVERRIDE_DEPRECATION") // where Jason 3.3 asks for some services
    override fun getRuntimeServices(): RuntimeServices? = RuntimeServicesFactory.get()
}

private const val RECORD = "argo_record"

/** Jason's own belief base. */
internal const val DEFAULT_BELIEFS = "jason.bb.DefaultBeliefBase"
