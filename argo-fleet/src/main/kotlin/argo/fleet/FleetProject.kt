package argo.fleet

import argo.fleet.cluster.ClusterSettings
import jason.asSyntax.ASSyntax
import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import jason.asSyntax.parser.ParseException
import jason.mas2j.AgentParameters
import jason.mas2j.MAS2JProject
import java.net.InetSocketAddress
import java.nio.file.Path

/** The project cannot run as a fleet; [message] tells the user why. */
internal class FleetProjectException(override val message: String) : Exception(message)

/**
 * An agent of the project.
 *
 * @property computers the computers that the agent may run on; it prefers the first
 */
internal class PlacedAgent(val name: String, val parameters: AgentParameters, val computers: List<String>) {
    /** Whether the agent outlives its computer. */
    val isMovable: Boolean get() = computers.size > 1

    /** The agent's options for Jason's pools of threads, which a fleet does not have. */
    val optionsWithoutEffect: Set<String> get() = parameters.options?.keys.orEmpty().intersect(OPTIONS_OF_POOLS)

    private companion object {
        val OPTIONS_OF_POOLS = setOf("rc", "cycles", "cycles_sense", "cycles_deliberate", "cycles_act")
    }
}

/**
 * The fleet in a `.mas2j`, as in this example:
 *
 *     infrastructure: Fleet(name(garden), hosts([base("10.8.0.1"), scout1("10.8.0.11:4712")]), port(4711), tls("certificates"))
 *
 * `hosts` names the computers, with the addresses at which they listen. A computer without an address is found by its name, as a host name.
 * A name that is no atom of AgentSpeak is in quotes: `"rasp-pi"`, or `host("rasp-pi","10.8.0.1")`. Without `hosts`, computers of one
 * network find each other. `insecure`, in place of `tls`, allows connections that everybody can read and forge.
 *
 * @property hosts the addresses of the computers, by their names; empty: computers find each other
 * @property agents the agents of all computers
 * @throws FleetProjectException if the description of the fleet is wrong
 */
internal class FleetProject(project: MAS2JProject) {
    private val options: List<Term> = optionsOf(project)

    val name: String = value("name")?.let(::text) ?: project.socName

    private val port: Int =
        value("port")?.let { portOf("$it") ?: refuse(it, "a port from 1 to $LAST_PORT") } ?: ClusterSettings.DEFAULT_PORT

    val hosts: Map<String, InetSocketAddress> = hosts()

    private val certificates: Path? = value("tls")?.let { Path.of(text(it)) }

    private val isInsecure: Boolean =
        options.find { it.functor == "insecure" }?.also { if ("$it" != "insecure") refuse(it, "insecure, or nothing,") } != null

    val agents: List<PlacedAgent> = project.agents.flatMap(::placed)

    init {
        val twice = agents.groupBy { it.name }.filterValues { it.size > 1 }.keys
        if (twice.isNotEmpty()) throw FleetProjectException("two agents are called ${twice.first()}; in a fleet each has a name of its own")
    }

    /** The agents of the project, each with the computers that it may run on. */
    val planned: Map<String, List<String>> get() = agents.associate { it.name to it.computers }

    /** The agents with a live view, each with the port of its view. */
    val views: Map<String, Int> get() = agents.mapNotNull { agent ->
        agent.parameters.options?.get(VIEW)?.let { portOf("$it".trim('"')) }?.let { agent.name to it }
    }.toMap()

    /**
     * Returns the settings of the computer [here].
     *
     * @param bind in a fleet without `hosts`, the address at which [here] listens; null: the loopback interface
     * @throws FleetProjectException if there is no such computer, or if others could reach it without TLS and the project lacks `insecure`
     */
    fun settings(here: String, bind: String?): ClusterSettings {
        val known = hosts.keys.ifEmpty { agents.flatMap { it.computers }.toSet() }
        if (here !in known) throw FleetProjectException("there is no computer $here in this fleet; there are ${known.joinToString()}")
        if (bind != null && hosts.isNotEmpty()) {
            val named = hosts.getValue(here).run { "$hostString:$port" }
            throw FleetProjectException("the project names the address of $here, $named, so --bind $bind has no meaning")
        }
        val address = hosts[here] ?: if (bind == null) ClusterSettings.loopback(port) else InetSocketAddress(bind, port)
        try {
            return ClusterSettings(name, here, hosts, address, certificates, isInsecure)
        } catch (contradiction: IllegalArgumentException) {
            throw FleetProjectException(contradiction.message.orEmpty())
        }
    }

    private fun optionsOf(project: MAS2JProject): List<Term> {
        val infrastructure = project.infrastructure
        if (infrastructure.className != INFRASTRUCTURE) {
            throw FleetProjectException(
                "this project says infrastructure: $infrastructure; a fleet says infrastructure: Fleet(name(…), hosts([…]))",
            )
        }
        val options = try {
            ASSyntax.parseList(infrastructure.parameters.joinToString(",", "[", "]")).asList
        } catch (unreadable: ParseException) {
            throw FleetProjectException(
                "$infrastructure cannot be read: ${unreadable.message?.lineSequence()?.first()}; a name in upper case stands in quotes," +
                    " as host(\"Pi\",\"10.8.0.1\")",
            )
        }
        val names = options.map { it.functor }
        names.find { it !in KNOWN }?.let { throw FleetProjectException("$it is no option of Fleet, which has ${KNOWN.joinToString()}") }
        names.groupBy { it }.values.find { it.size > 1 }?.let { throw FleetProjectException("Fleet has the option ${it.first()} twice") }
        if (names.containsAll(listOf("tls", "insecure"))) {
            throw FleetProjectException("Fleet has tls(…) and insecure, of which only one can be meant")
        }
        return options
    }

    private fun hosts(): Map<String, InetSocketAddress> {
        val option = options.find { it.functor == "hosts" } ?: return emptyMap()
        val list = argument(option) as? ListTerm ?: refuse(option, "hosts([base(\"10.8.0.1\"), scout1(\"10.8.0.11\")])")
        val hosts = list.asList.map(::host)
        hosts.groupBy { it.first }.values.find { it.size > 1 }?.let {
            throw FleetProjectException("two computers are called ${it.first().first}")
        }
        return hosts.toMap()
    }

    private fun host(host: Term): Pair<String, InetSocketAddress> {
        val parts = when {
            host is StringTerm -> listOf(host.string)
            host !is Literal -> emptyList()
            host.functor == NAMED && host.arity == 2 -> host.terms.map(::text)
            else -> listOf(host.functor) + host.terms.orEmpty().map(::text)
        }
        if (parts.size !in 1..2) refuse(host, "a computer, as base(\"10.8.0.1\") or $NAMED(\"rasp-pi\",\"10.8.0.1\")")
        return parts.first() to addressOf(parts.last())
    }

    /** Reads `10.8.0.1`, `10.8.0.1:4711` or `[fd00::1]:4711`. */
    private fun addressOf(text: String): InetSocketAddress {
        val match = ADDRESS.matchEntire(text) ?: throw FleetProjectException("$text is no address, as 10.8.0.1 or 10.8.0.1:$port")
        val (bracketed, plain, written) = match.destructured
        val port = if (written.isEmpty()) port else portOf(written)
            ?: throw FleetProjectException("$text: a port is from 1 to $LAST_PORT")
        return InetSocketAddress(bracketed.ifEmpty { plain }, port)
    }

    private fun placed(parameters: AgentParameters): List<PlacedAgent> {
        val computers = parameters.host?.split(',')?.map { it.trim() }?.filter { it.isNotEmpty() }.orEmpty()
        if (computers.isEmpty()) {
            throw FleetProjectException("agent ${parameters.name} is at no computer: ${parameters.name} … at \"base\";")
        }
        computers.find { hosts.isNotEmpty() && it !in hosts }?.let {
            throw FleetProjectException("agent ${parameters.name} is at $it, which is none of the hosts ${hosts.keys.joinToString()}")
        }
        if (computers.size > 1) requireMovable(parameters, computers)
        val count = parameters.nbInstances
        return if (count == 1) listOf(PlacedAgent(parameters.name, parameters, computers))
        else (1..count).map { PlacedAgent("${parameters.name}$it", parameters, computers) }
    }

    private fun requireMovable(parameters: AgentParameters, computers: List<String>) {
        if (hosts.isEmpty()) {
            throw FleetProjectException(
                "agent ${parameters.name} is at ${computers.joinToString()}: to run it once, most computers have to agree, so " +
                    "Fleet names them in hosts([…])",
            )
        }
        if (computers.size != computers.toSet().size) throw FleetProjectException("agent ${parameters.name} is at a computer twice")
        if (RESUME in parameters.options.orEmpty()) {
            throw FleetProjectException(
                "agent ${parameters.name} is at ${computers.joinToString()}, and has $RESUME: the computers know what it believes, and a" +
                    " file of one of them may be older; leave $RESUME out",
            )
        }
    }

    private fun value(option: String): Term? = options.find { it.functor == option }?.let(::argument)

    private fun argument(option: Term): Term =
        (option as? Literal)?.takeIf { it.arity == 1 }?.getTerm(0) ?: refuse(option, "${option.functor}(…) with one argument")

    private fun refuse(found: Term, expected: String): Nothing = throw FleetProjectException("Fleet has $found where $expected is expected")

    companion object {
        const val INFRASTRUCTURE = "Fleet"
        private const val VIEW = "argo_view"
        private const val RESUME = "argo_resume"
        private val KNOWN = listOf("name", "hosts", "port", "tls", "insecure")

        /** The functor for a computer whose name is no atom of AgentSpeak. */
        private const val NAMED = "host"
        private val ADDRESS = Regex("""(?:\[([0-9a-fA-F:.]+)]|([^:\[\]]+))(?::(\d+))?""")
        private const val LAST_PORT = 65_535

        private val Term.functor: String get() = (this as? Literal)?.functor ?: "$this"

        private fun text(term: Term): String = if (term is StringTerm) term.string else "$term"

        private fun portOf(text: String): Int? = text.toIntOrNull()?.takeIf { it in 1..LAST_PORT }
    }
}
