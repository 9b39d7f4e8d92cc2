package argo.recording.replay

import argo.Arch
import argo.boundary.Boundary
import argo.insides.IncludeDirective
import argo.insides.Insides
import argo.links.BoardLink
import argo.orders.ProgramSource
import argo.orders.unreadableAt
import argo.platform.Platform
import argo.recording.RecordedAgent
import argo.recording.agent.Counters
import jason.architecture.AgArch
import jason.asSemantics.Agent
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSyntax.parser.ParseException
import jason.bb.DefaultBeliefBase
import jason.runtime.RuntimeServices
import jason.runtime.RuntimeServicesFactory
import jason.runtime.Settings
import jason.util.Config
import javino.LineClock
import javino.NoSuchPortException
import javino.link.LinkSettings
import java.nio.file.Files
import java.nio.file.Path

/**
 * Makes Jason create an agent like [recorded], without ports, threads and its own clock. All its input comes from [boundary].
 *
 * @param isCarryingOut whether an architecture of the project, which may do anything, may be made
 * @param observers options of observers, such as `argo_debug=4711`. The recorded options of observers are left out, since they might start
 * a live view
 * @throws RecordingException if Jason cannot read the program, or if a class of the agent is missing or not allowed in a replay
 */
internal fun jasonAgent(
    recorded: RecordedAgent,
    source: Path,
    includes: RecordedIncludes,
    boundary: Boundary,
    isCarryingOut: Boolean = !includes.isOfRecordedProgram,
    observers: Map<String, String> = emptyMap(),
): TransitionSystem {
    requireJasons(recorded, recorded.agentClass, Agent::class.java.name)
    requireJasons(recorded, recorded.beliefBase, DefaultBeliefBase::class.java.name)
    val archType = archType(recorded, isCarryingOut)
    val settings = Settings().apply { setOptions(HashMap<String, Any>(recorded.options.filterKeys(::isOfAgent) + observers)) }
    val infra = Infra(recorded)
    val address = recorded.address.takeIf { includes.isOfRecordedProgram }
    load(recorded) {
        ofConfiguration(recorded) {
            recorded.firstLabel?.let(Counters::nameFrom)
            IncludeDirective.install()
            IncludeDirective.within(includes) { create(GuardedAgent(includes.watch), infra, settings) { it.read(source, address) } }
        }
    }
    val ts = infra.ts
    includes.running = ts.ag
    infra.insertAgArch(infra)
    val arch = newArch(recorded, archType, ReplayPlatform(boundary))
    arch.ts = ts
    infra.insertAgArch(arch)
    arch.init()
    ts.logger.useParentHandlers = false // the recording contains the printed lines
    return ts
}

/** Does the work of [Agent.create], which can read a program only from its own address. */
private fun create(agent: Agent, infra: AgArch, settings: Settings, read: (Agent) -> Unit) {
    TransitionSystem(agent, null, settings, infra)
    agent.bb = DefaultBeliefBase()
    agent.initAg()
    read(agent)
}

/** Reads the program in the file [source]. Jason's annotations and errors name [address] or, if it is null, [source]. */
private fun Agent.read(source: Path, address: String?) {
    if (address == null) return loadInitialAS("$source")
    Files.newInputStream(source).use { parseAS(it, ProgramSource.nameOf(address)) }
    loadInitialAS(null) // does the rest
    aslSrc = address
}

/** Makes Jason forget its selections, as in [cycles] cycles in which nothing happens. A recording leaves these cycles out. */
internal fun TransitionSystem.rest(cycles: Int) {
    if (cycles <= 0) return
    c.resetDeliberate()
    c.resetAct()
    repeat(cycles) {
        val unperceived = Insides.cyclesUnperceived[this]
        Insides.cyclesUnperceived[this] = if (unperceived >= settings.nrcbp()) 1 else unperceived + 1
        if (settings.nrcbp() <= 1) return
    }
}

/**
 * Carries out the reasoning cycle with this [number]. Takes included files from [includes]. For [isConditional] see
 * [RecordedAgent.isConditional].
 */
internal fun TransitionSystem.cycle(number: Int, isConditional: Boolean, includes: RecordedIncludes) = IncludeDirective.within(includes) {
    val first = agArch
    first.cycleNumber = number
    first.reasoningCycleStarting()
    sense()
    if (!isConditional || !canSleepDeliberate()) deliberate()
    if (!isConditional || !canSleepAct()) act()
    first.reasoningCycleFinished()
}

internal fun TransitionSystem.end() {
    logger.useParentHandlers = true
    ag.stopAg()
    agArch.stop()
}

private fun load(recorded: RecordedAgent, create: () -> Unit) = try {
    create()
} catch (missing: LinkageError) {
    throw RecordingException("the program of agent ${recorded.name} cannot be loaded, since a class is missing or another: $missing")
} catch (refused: Exception) { // Jason declares no narrower type
    generateSequence<Throwable>(refused) { it.cause }.firstNotNullOfOrNull { it as? RecordingException }?.let { throw it }
    val unreadable = generateSequence<Throwable>(refused) { it.cause }.firstNotNullOfOrNull { it as? ParseException }
    val why = unreadable?.let(::unreadableAt) ?: refused.message
    throw RecordingException("Jason cannot read the program of agent ${recorded.name}: $why")
}

/**
 * Calls [create] with the settings of [recorded] and with Jason's own plans for messages. Jason reads most settings when it makes an agent.
 * Jason reads some settings only once, when Java makes the first term.
 */
private fun ofConfiguration(recorded: RecordedAgent, create: () -> Unit) =
    reading(recorded.config + (Config.KQML_PLANS_FILE to Message.kqmlDefaultPlans), create)

/**
 * Calls [read], in which Jason reads a program. Uses [settings], but switches off Jason's server for showing agents, which would also show
 * each block of a program as an agent.
 */
internal fun <T> reading(settings: Map<String, String> = emptyMap(), read: () -> T): T {
    val config = Config.get()
    val wanted = settings + (Config.START_WEB_MI to "false")
    val before: Map<String, Any?> = wanted.mapValues { (name, value) -> config.setProperty(name, value) }
    try {
        return read()
    } finally {
        before.forEach { (name, value) -> if (value == null) config.remove(name) else config[name] = value }
    }
}

/** Refuses the class [name] of an agent if it is not Jason's own class [jasons]. The constructor of another class may do anything. */
private fun requireJasons(recorded: RecordedAgent, name: String, jasons: String) {
    if (name != jasons) throw RecordingException("agent ${recorded.name} had the class $name, and a replay makes only $jasons")
}

private fun archType(recorded: RecordedAgent, isCarryingOut: Boolean): Class<out Arch> {
    val name = recorded.archClass
    if (name == Arch::class.java.name) return Arch::class.java
    if (!isCarryingOut) {
        throw RecordingException(
            "agent ${recorded.name} had the architecture $name; a class of the project may do anything, so only replay --check makes it, " +
                "and replay --agent with a program of yours",
        )
    }
    val type = classOrNull(name) ?: throw RecordingException(
        "agent ${recorded.name} needs the class $name, which is not on the class path; add the classes and jars of its project to it",
    )
    if (Arch::class.java.isAssignableFrom(type)) return type.asSubclass(Arch::class.java)
    throw RecordingException("agent ${recorded.name} had the architecture $name, which is not argo.Arch")
}

private fun newArch(recorded: RecordedAgent, type: Class<out Arch>, platform: Platform): Arch {
    val constructor = type.constructors.find { it.parameterTypes.contentEquals(arrayOf(Platform::class.java)) }
        ?: throw RecordingException(
            "agent ${recorded.name} had the architecture ${type.name}, to which a replay cannot give its platform without ports: add a " +
                "constructor public ${type.simpleName}(argo.platform.Platform platform) { super(platform); }",
        )
    return try {
        constructor.newInstance(platform) as Arch
    } catch (broken: ReflectiveOperationException) {
        throw RecordingException("the architecture ${type.name} of agent ${recorded.name} cannot be made: ${broken.cause ?: broken}")
    }
}

/** Returns the class [type] without initializing it; null if it is not on the class path. */
internal fun classOrNull(type: String): Class<*>? = try {
    Class.forName(type, false, ReplayPlatform::class.java.classLoader)
} catch (_: ClassNotFoundException) {
    null
} catch (_: LinkageError) { // on a disk that ignores case, Java finds the class of a name in another case
    null
}

/** Returns true if a replayed agent also gets [option]. Options that start observers are left out. */
private fun isOfAgent(option: String) = !option.startsWith("argo_") || option == "argo_sensing" || option == "argo_percepts"

private class Infra(private val recorded: RecordedAgent) : AgArch() {
    override fun getAgName() = recorded.name

    @Suppress("OVERRIDE_DEPRECATION") // Jason 3.3 gets some services from this function
    override fun getRuntimeServices(): RuntimeServices? = RuntimeServicesFactory.get()
}

/** The platform of an agent in a replay, with the recorded input. Opens no port and runs no thread. */
internal class ReplayPlatform(override val boundary: Boundary) : Platform {
    override val clock: LineClock = LineClock.system()
    override val standsStill get() = true

    /** Returns a thread that never runs. An agent starts a thread to close its ports, but a replayed agent has no ports. */
    override fun start(name: String, run: () -> Unit) = Thread(run, name)

    override fun later(delayMs: Long, action: () -> Unit) = Unit

    override fun open(port: String, settings: LinkSettings, owner: String): BoardLink =
        throw NoSuchPortException(port, "a replay has no ports")

    override fun isPresent(port: String) = false
}
