package argo.ros.serving

import argo.ros.bridge.text
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.util.concurrent.TimeUnit

/**
 * The services of the node `rosapi` with which clients explore a graph.
 *
 * @param epochMs the time of day, in ms since 1970
 */
internal class RosApiServices(private val graph: Graph, private val epochMs: () -> Long) {
    /**
     * Returns the response of the service [name].
     *
     * @throws RefusedRequest if there is no such service
     */
    fun answer(name: String, request: JsonObject): JsonObject {
        val topics = graph.topics.types.toSortedMap()
        val services = graph.services().toSortedMap()
        val asked = ASKED.firstNotNullOfOrNull(request::text).orEmpty()
        return when (name.removePrefix(BASE)) {
            "topics" -> answer("topics" to texts(topics.keys), "types" to texts(topics.values))
            "topics_and_raw_types" -> answer(
                "topics" to texts(topics.keys), "types" to texts(topics.values),
                "typedefs_full_text" to texts(topics.values.map { MessageTypes.textOf(it) }),
            )
            "topic_type" -> answer("type" to JsonPrimitive(topics[asked].orEmpty()))
            "topics_for_type" -> answer("topics" to texts(topics.filterValues { plain(it) == plain(asked) }.keys))
            "services" -> answer("services" to texts(services.keys))
            "service_type" -> answer("type" to JsonPrimitive(services[asked].orEmpty()))
            "services_for_type" -> answer("services" to texts(services.filterValues { plain(it) == plain(asked) }.keys))
            "service_node" -> answer("node" to JsonPrimitive(graph.targetOrNull(asked)?.let { "/${it.participant.name}" }.orEmpty()))
            "action_servers" -> answer("action_servers" to texts(graph.actions()))
            "nodes" -> answer("nodes" to texts(graph.nodes))
            "node_details" -> answer(
                "subscribing" to texts(emptyList()),
                "publishing" to texts(topics.keys.filter { it.startsWith("$asked/") }),
                "services" to texts(services.keys.filter { it.startsWith("$asked/") }),
            )
            "message_details" -> details(plain(asked))
            "service_request_details" -> details("${plain(asked)}Request")
            "service_response_details" -> details("${plain(asked)}Response")
            "get_param_names" -> answer("names" to texts(emptyList()))
            "get_time" -> answer("time" to time())
            else -> throw RefusedRequest("there is no service $name")
        }
    }

    /** @throws RefusedRequest if [type] is not described here; an empty answer would say that there is no such type */
    private fun details(type: String): JsonObject =
        answer("typedefs" to (MessageTypes.details(type).takeIf { it.isNotEmpty() } ?: throw RefusedRequest("$type is not described here")))

    private fun time(): JsonObject {
        val ms = epochMs()
        val seconds = TimeUnit.MILLISECONDS.toSeconds(ms)
        val nanos = TimeUnit.MILLISECONDS.toNanos(ms - TimeUnit.SECONDS.toMillis(seconds))
        return JsonObject(mapOf("secs" to JsonPrimitive(seconds), "nsecs" to JsonPrimitive(nanos)))
    }

    private fun answer(vararg values: Pair<String, JsonElement>) = JsonObject(mapOf(*values))

    private fun texts(values: Collection<String>) = JsonArray(values.map { JsonPrimitive(it) })

    companion object {
        const val BASE = "/rosapi/"

        /** The fields of requests, one of which names their subject. */
        private val ASKED = listOf("topic", "service", "type", "node")

        /** The types of these services, by name. */
        val TYPES: Map<String, String> = mapOf(
            "topics" to "Topics", "topic_type" to "TopicType", "topics_for_type" to "TopicsForType", "services" to "Services",
            "topics_and_raw_types" to "TopicsAndRawTypes", "service_type" to "ServiceType", "services_for_type" to "ServicesForType",
            "service_node" to "ServiceNode", "action_servers" to "GetActionServers", "nodes" to "Nodes", "node_details" to "NodeDetails",
            "message_details" to "MessageDetails", "service_request_details" to "ServiceRequestDetails",
            "service_response_details" to "ServiceResponseDetails", "get_param_names" to "GetParamNames", "get_time" to "GetTime",
        ).map { (name, type) -> "$BASE$name" to "rosapi/$type" }.toMap()

        /** Returns [type] as ROS 1 writes it. */
        fun plain(type: String): String = type.replace("/msg/", "/").replace("/srv/", "/").replace("/action/", "/")
    }
}
