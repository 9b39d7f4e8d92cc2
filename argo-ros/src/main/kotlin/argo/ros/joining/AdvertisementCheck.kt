package argo.ros.joining

import argo.ros.bridge.RosApi
import argo.ros.mapping.rosType

/**
 * Checks that the advertised topics and services exist in the graph. A bridge does not report refusals to its clients.
 *
 * @param warn takes reports of missing topics and services, each text once
 * @param lost called if the graph has lost all topics and services of a participant, for example after a restart of `roscore`
 */
internal class AdvertisementCheck(private val api: RosApi, private val warn: (String) -> Unit, private val lost: () -> Unit) {
    private var wasSeen = false // only the bridge's thread uses it

    /** Asks for the topics and services of the graph, and compares them and their types with [topics] and [services]. */
    fun check(topics: Map<String, String>, services: Map<String, String>) {
        api.ask("/rosapi/topics").thenCombine(api.ask("/rosapi/services")) { known, offered ->
            val shown = known.texts("topics").orEmpty().zip(known.texts("types").orEmpty()).toMap()
            compare(shown, offered.texts("services").orEmpty().toSet(), topics, services)
        }.whenComplete { _, trouble ->
            val reason = trouble?.cause?.message.orEmpty()
            if ((trouble?.cause as? RosApi.NotKnown)?.isMissing == true) warn(NO_ROSAPI)
            else if (reason.isNotEmpty()) warn("rosapi does not tell what the graph has: $reason")
        }
    }

    private fun compare(
        shown: Map<String, String>, offered: Set<String>, topics: Map<String, String>, services: Map<String, String>,
    ) {
        val isSeen = topics.keys.any { it in shown } || services.keys.any { it in offered }
        if (wasSeen && !isSeen) return lost()
        wasSeen = isSeen
        val others = topics.filter { (name, type) -> shown[name].orEmpty().ifEmpty { type }.let(::rosType) != type }
        others.forEach { (name, type) -> warn("$name is of type ${shown[name]} in the graph, so messages of type $type do not get there") }
        val missing = topics.filterKeys { it !in shown } + services.filterKeys { it !in offered }
        if (missing.isEmpty()) return
        val names = missing.entries.joinToString(", ") { (name, type) -> "$name ($type)" }
        val cause = if (missing.values.none { it.startsWith(PACKAGE) }) "" else "; is the package $PACKAGE in the workspace of the bridge?"
        warn("the graph does not show what was advertised: $names$cause")
    }

    private companion object {
        const val PACKAGE = "argo_msgs"
        const val NO_ROSAPI = "rosapi does not run beside the bridge, so nobody can tell which of these topics and services the graph has"
    }
}
