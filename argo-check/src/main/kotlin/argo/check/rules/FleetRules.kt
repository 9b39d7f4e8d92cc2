package argo.check.rules

import argo.check.project.MasAgent
import argo.check.project.MasFile
import argo.check.project.MasFleet

internal object FleetRules {
    private const val RULE = "fleet"
    private const val REFUSED = "the fleet refuses the project"
    private val OPTIONS = setOf("name", "hosts", "port", "tls", "insecure")

    fun check(file: MasFile, report: Report) {
        val fleet = file.fleet
        if (fleet != null) {
            fleet(fleet, report)
            file.agents.forEach { agent(it, fleet, report) }
        } else if (!file.isDistributed) {
            file.agents.mapNotNull { it.computers }.firstOrNull()?.let {
                report.warning(RULE, it.span, "at ${it.text} has no effect", "Jason runs all agents of this project on one computer",
                    "infrastructure: Fleet(hosts([…]))")
            }
        }
    }

    private fun fleet(fleet: MasFleet, report: Report) {
        fleet.options.filter { it.text !in OPTIONS }.forEach {
            report.error(RULE, it.span, "$it is no option of Fleet", REFUSED,
                SimilarNames.near(it.text, OPTIONS)?.let { name -> "did you mean $name?" } ?: "there are ${OPTIONS.joinToString()}")
        }
        fleet.hosts.groupBy { it.text }.values.mapNotNull { it.getOrNull(1) }.forEach {
            report.error(RULE, it.span, "two computers are called $it", REFUSED, "give each a name of its own")
        }
    }

    private fun agent(agent: MasAgent, fleet: MasFleet, report: Report) {
        val at = agent.computers
        if (at == null) {
            report.error(RULE, agent.name.span, "agent ${agent.name} is at no computer", REFUSED, "${agent.name} … at \"base\";")
            return
        }
        val known = fleet.hosts.map { it.text }
        val computers = computersOf(agent)
        if (computers.size > 1 && known.isEmpty()) {
            report.error(RULE, at.span, "agent ${agent.name} is at several computers of a fleet without hosts", REFUSED,
                "most computers have to agree where it runs: name them in hosts([…])")
        }
        computers.filter { known.isNotEmpty() && it !in known }.forEach {
            report.error(RULE, at.span, "agent ${agent.name} is at $it, which is none of the fleet's hosts", REFUSED,
                SimilarNames.near(it, known)?.let { name -> "did you mean $name?" } ?: "there are ${known.joinToString()}")
        }
    }

    /** Warns if [agent] uses boards and moves to another computer when its own computer fails. */
    fun board(file: MasFile, agent: MasAgent, report: Report) {
        val at = agent.computers?.takeIf { file.fleet != null && computersOf(agent).size > 1 } ?: return
        report.warning(RULE, at.span, "agent ${agent.name} uses boards, and runs on another computer when its own goes",
            "its boards stay where they are", "leave it at one computer, and the part that moves to an agent without boards")
    }

    private fun computersOf(agent: MasAgent) =
        agent.computers?.text.orEmpty().trim('"').split(',').map { it.trim() }.filter { it.isNotEmpty() }
}
