package argo.ros.bridge

import javino.LineClock
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong

/**
 * Calls services of the node `rosapi`, which usually runs beside a bridge. A ROS 1 bridge reports no errors to its clients. Questions to
 * `rosapi` find them. Safe for use by several threads.
 */
internal class RosApi(private val clock: LineClock, private val send: (Outgoing) -> Unit) : AutoCloseable {
    /** An answer, and the platform time of its arrival. */
    class Answer(val values: JsonObject, val receivedNanos: Long) {
        fun text(name: String): String? = values.text(name)

        fun texts(name: String): List<String>? = (values[name] as? JsonArray)?.mapNotNull { (it as? JsonPrimitive)?.content }
    }

    private val calls = ConcurrentHashMap<String, CompletableFuture<Answer>>()
    private val number = AtomicLong()

    @Volatile
    var isThere = false
        private set

    /**
     * Calls [service]. The result completes on the bridge's thread. If the call fails or exceeds [LIMIT_NANOS], it completes with a
     * [NotKnown].
     */
    fun ask(service: String, arguments: Map<String, String> = emptyMap()): CompletableFuture<Answer> {
        val id = "$ID${number.incrementAndGet()}"
        val call = CompletableFuture<Answer>()
        calls[id] = call
        call.whenComplete { _, _ -> calls -= id }
        val written = JsonObject(arguments.mapValues { JsonPrimitive(it.value) })
        send(Outgoing(operation("call_service", "id" to id, "service" to service, "args" to written)))
        if (!call.isDone) clock.schedule(LIMIT_NANOS) { call.completeExceptionally(NotKnown("")) }
        return call
    }

    /** Handles a message that arrived at [nowNanos]. Returns false if it answers no call of this object. */
    fun heard(operation: JsonObject, nowNanos: Long): Boolean {
        val id = operation.text("id")?.takeIf { it.startsWith(ID) && operation.text("op") == "service_response" } ?: return false
        val call = calls[id] ?: return true // the call has timed out, or the link is closed
        val values = operation.part("values")
        if (values == null || operation.flag("result") == false) call.completeExceptionally(NotKnown(operation.text("values").orEmpty()))
        else call.complete(Answer(values, nowNanos)).also { isThere = true }
        return true
    }

    override fun close() = calls.values.forEach { it.completeExceptionally(NotKnown("")) }

    /** @param reason the bridge's reason, or an empty text without one */
    class NotKnown(reason: String) : Exception(reason) {
        /** True if the called service does not exist, for example because `rosapi` does not run. */
        val isMissing: Boolean get() = MISSING in message.orEmpty()
    }

    companion object {
        private const val ID = "argo-api-"

        private const val MISSING = "does not exist"

        val LIMIT_NANOS = TimeUnit.SECONDS.toNanos(10)
    }
}
