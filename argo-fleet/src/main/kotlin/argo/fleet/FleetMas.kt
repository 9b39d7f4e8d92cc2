package argo.fleet

import argo.fleet.agents.DirectoryFacilitator
import argo.fleet.agents.FleetAgArch
import argo.fleet.agents.FleetServices
import argo.fleet.cluster.Refused
import argo.fleet.node.Directory
import argo.fleet.node.Fleet
import argo.fleet.node.Kill
import argo.fleet.node.LeasedAgents
import argo.fleet.node.LocalAgents
import argo.fleet.node.MindNews
import argo.fleet.node.Reign
import argo.fleet.node.Say
import argo.fleet.node.Stop
import argo.fleet.node.Takeover
import argo.fleet.node.Unanswered
import argo.insides.Insides
import argo.recording.agent.AwaitedOutside
import jason.JasonException
import jason.infra.local.LocalAgArch
import jason.infra.local.RunLocalMAS
import jason.mas2j.ClassParameters
import jason.mas2j.parser.ParseException
import jason.mas2j.parser.TokenMgrError
import jason.mas2j.parser.mas2j
import jason.runtime.MASConsoleLogFormatter
import jason.runtime.RuntimeServicesFactory
import java.io.File
import java.io.IOException
import java.io.InputStream
import java.util.concurrent.Executors
import java.util.concurrent.Future
import java.util.concurrent.TimeUnit
import java.util.logging.ConsoleHandler
import java.util.logging.Level
import java.util.logging.LogManager
import java.util.logging.Logger
import kotlin.random.Random

/** Runs the agents of one computer of a fleet by Jason's infrastructure for a single computer. */
internal class FleetMas :
    RunLocalMAS(),
    LocalAgents,
    LeasedAgents {
    private lateinit var placed: List<PlacedAgent>
    private lateinit var takeover: Takeover
    private lateinit var fleet: Fleet
    private lateinit var services: FleetServices
    private lateinit var facilitator: DirectoryFacilitator
    private var comparing: Future<*>? = null
    private val log = Logger.getLogger(LOG)

    /**
     * This thread starts and stops agents that outlive their computers: the takeover must not wait while an agent's program is read. It
     * does one start or stop at a time, so that no agent is created twice. Now and then it also compares rosters.
     */
    private val starter = Executors.newSingleThreadScheduledExecutor { Thread(it, "argo-fleet-start").apply { isDaemon = true } }

    init {
        starter.execute {} // creates the thread now, since the machine may have none left later
        numberMessages()
    }

    /**
     * Has Jason number this program's messages from a random number. Otherwise an agent that begins again soon would ask with the numbers
     * of its last run, and take a late answer to an old question for that to a new one.
     */
    private fun numberMessages() = Insides.messageCounter.let { if (it.isThere) it[null].set(Random.nextInt(MOST_NUMBERS_LEFT_OUT)) }

    /**
     * Reads the project in [file].
     *
     * @throws FleetProjectException if the file has a wrong form
     */
    fun read(file: String): FleetProject {
        requireForm(File(file))
        init(arrayOf(file, "--no-net"))
        useJasonsFormat()
        val read = FleetProject(project)
        project.infrastructure = ClassParameters(LOCAL) // Jason expects options of its own infrastructure here
        return read
    }

    /** Reads [file] once before Jason does: if the form is wrong, Jason ends the program with a stack trace. */
    private fun requireForm(file: File) = try {
        file.inputStream().use { mas2j(it).mas() }
    } catch (unreadable: TokenMgrError) {
        throw FleetProjectException("${unreadable.message}; a name with a hyphen stands in quotes, as host(\"rasp-pi\",\"10.8.0.1\")")
    } catch (unreadable: ParseException) {
        val (before, found) = unreadable.currentToken.run { image to next?.image }
        throw FleetProjectException(
            if (before == "[" && found == "]") "the list of hosts is empty; without hosts([…]), computers of one network find each other"
            else "it is no project: ${unreadable.message?.lineSequence()?.first()}",
        )
    }

    /** The log's settings if the project has no file for them. The log goes to the console, not to Jason's usual window. */
    override fun getDefaultLogProperties(): InputStream = DEFAULT_LOG.byteInputStream()

    /** Sets Jason's formatter of the log. Java itself looks for it only on the program's class path, where Jason may not be. */
    private fun useJasonsFormat() {
        val wanted = LogManager.getLogManager().getProperty("java.util.logging.ConsoleHandler.formatter")
        if (wanted != MASConsoleLogFormatter::class.java.name) return
        Logger.getLogger("").handlers.filterIsInstance<ConsoleHandler>().forEach { it.formatter = MASConsoleLogFormatter() }
    }

    /** Creates those of [agents] that belong to this computer only, joins [fleet], and then lets these agents begin. */
    fun run(fleet: Fleet, agents: List<PlacedAgent>, hosts: Int) {
        this.fleet = fleet
        placed = agents
        facilitator = DirectoryFacilitator(fleet) { getAg(it.receiver)?.receiveMsg(it) }
        services = FleetServices(this, fleet, facilitator, log)
        takeover = Takeover(fleet, agents.filter { it.isMovable }.associate { it.name to it.computers }, hosts, this, log)
        RuntimeServicesFactory.set(services)
        agents.filter { fleet.here in it.computers }.forEach(::tellWithoutEffect)
        create()
        fleet.join(this, takeover)
        fleet.awaitOthers(MEETING_MS) // so that no first message finds its receiver's computer unknown
        start()
        takeover.begin()
        comparing = starter.scheduleWithFixedDelay(::compare, COMPARING_S, COMPARING_S, TimeUnit.SECONDS)
    }

    private fun compare() = try {
        fleet.compare(Random)
    } catch (@Suppress("TooGenericExceptionCaught") failed: Throwable) { // it would end the comparisons
        log.log(Level.SEVERE, "what other computers know was not compared: ${failed.message}", failed)
    }

    override fun createAgs() = placed.filter { it.computers == listOf(fleet.here) }.forEach { agent ->
        try {
            createdAgents.add(create(agent) { FleetAgArch(fleet) })
        } catch (@Suppress("TooGenericExceptionCaught") failed: Throwable) { // a class that an agent needs may be missing
            val unexpected = failed.takeUnless { it is IOException || it is JasonException } // these say all in words
            log.log(Level.SEVERE, "agent ${agent.name} cannot be created: ${failed.message}", unexpected)
        }
    }

    /** Creates [agent] and returns its infrastructure. */
    private fun create(agent: PlacedAgent, architecture: () -> FleetAgArch): FleetAgArch {
        val wanted = agent.parameters
        services.createOwn(agent.name, architecture) {
            createAgent(
                agent.name, "${wanted.source}", wanted.agClass.className, wanted.agArchClasses, wanted.bbClass,
                wanted.getAsSetts(debug, project.controlClass != null), null,
            )
        }
        return getAg(agent.name) as FleetAgArch
    }

    private fun tellWithoutEffect(agent: PlacedAgent) {
        val odd = agent.optionsWithoutEffect
        if (odd.isNotEmpty()) log.warning("${agent.name}: ${odd.joinToString()} has no effect in a fleet")
    }

    override fun start(agent: String, reign: Reign, mind: MindNews?) = starter.execute {
        try {
            val program = placed.first { it.name == agent }
            begin(create(program) { FleetAgArch(fleet, reign, mind, takeover::keep) { endReign(agent, reign, it) } }, reign, mind)
        } catch (@Suppress("TooGenericExceptionCaught") failed: Throwable) { // the machine may have no thread left
            endReign(agent, reign, failed)
        }
    }

    private fun endReign(agent: String, reign: Reign, failure: Throwable) {
        takeover.cannotRun(agent, reign, failure)
        stop(agent)
    }

    private fun begin(created: FleetAgArch, reign: Reign, mind: MindNews?) {
        val agent = created.agName
        if (reign.isValid()) {
            services.startAgent(agent)
            log.info("$agent runs on ${fleet.here} now" + if (mind == null) "" else ", with what it believed")
        } else {
            stop(created)
            takeover.giveUp(agent, reign) // otherwise new grants could make the reign valid again, with no agent running
        }
    }

    override fun stop(agent: String) = starter.execute { getAg(agent)?.let(::stop) }

    /** Stops [agent]. Does not remove another agent that has the same name by now. */
    private fun stop(agent: LocalAgArch) {
        agent.stopAg()
        if (getAg(agent.agName) === agent) delAg(agent.agName)
    }

    override fun addAg(agent: LocalAgArch) {
        super.addAg(agent)
        fleet.came(agent.agName)
    }

    override fun delAg(name: String): LocalAgArch? = super.delAg(name)?.also {
        facilitator.agentEnded(name)
        fleet.gone(name)
    }

    override fun take(message: Say) {
        val receiver = getAg(message.to) as? FleetAgArch ?: throw noAgent(message.to)
        receiver.take(message)
    }

    override fun take(message: Unanswered) {
        (getAg(message.to) as? FleetAgArch)?.take(message)
    }

    override fun kill(wanted: Kill) {
        if (getAg(wanted.agent) == null) throw noAgent(wanted.agent)
        if (!services.killAgent(wanted.agent, wanted.by, wanted.deadlineMs)) {
            throw Refused("not_killed", "${wanted.agent} does not let ${wanted.by} kill it")
        }
    }

    private fun noAgent(name: String) = Refused(AwaitedOutside.NO_AGENT, "there is no agent $name on ${fleet.here}")

    override fun stop(wanted: Stop) = finish(wanted.deadlineMs, wanted.stopsJvm, wanted.exitStatus)

    override fun directoryChanged(before: Directory, now: Directory) {
        facilitator.directoryChanged(before, now)
        ags.values.forEach { (it as FleetAgArch).directoryChanged(now) }
    }

    override fun refused(reason: String) {
        log.severe("${fleet.here} cannot take part in the fleet, and ends: $reason")
        finish(0, true, FAILED)
    }

    override fun finish(deadline: Int, stopJVM: Boolean, exitValue: Int) {
        comparing?.cancel(false)
        if (::takeover.isInitialized) takeover.close()
        super.finish(deadline, stopJVM, exitValue)
    }

    companion object {
        /** The name of the fleet's own log. */
        const val LOG = "argo.fleet"
        private val DEFAULT_LOG =
            """
            handlers = java.util.logging.ConsoleHandler
            java.util.logging.ConsoleHandler.formatter = ${MASConsoleLogFormatter::class.java.name}
            .level = INFO
            """.trimIndent()
        private const val LOCAL = "Local"
        private const val FAILED = 1
        private const val MEETING_MS = 1000L
        private const val COMPARING_S = 15L

        /** Half of the numbers, so that the others last for the messages of a run. */
        private const val MOST_NUMBERS_LEFT_OUT = 1 shl 30
    }
}
