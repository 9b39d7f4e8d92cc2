package argo.ros.bridge

import argo.filters.Problem
import argo.ros.mapping.Mapping
import argo.ros.mapping.MappingException
import argo.ros.mapping.Refusal
import argo.ros.mapping.checkField
import argo.ros.mapping.fields
import javino.LineClock
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import java.util.concurrent.atomic.AtomicLong

/**
 * Asks the node `rosapi`, which often runs beside a bridge, for the robot's time and for the fields of types. Where it does not run, neither
 * is known. Safe for use by several threads.
 *
 * @param offset takes the times
 * @param send sends a message to the bridge
 * @param tell takes the offset of the clocks, for a person, when it is known and when it has changed much
 */
internal class RosApi(
    private val clock: LineClock,
    private val offset: ClockOffset,
    private val send: (Outgoing) -> Unit,
    private val tell: (String) -> Unit,
) : AutoCloseable {
    private val calls = ConcurrentHashMap<String, CompletableFuture<JsonObject>>()
    private val number = AtomicLong()

    @Volatile
    private var dueNanos: Long? = null // for the next time; null: nobody knows it

    @Volatile
    private var askedNanos = 0L
    private var toldNanos: Long? = null // these two are used by the bridge's thread alone
    private var answers = 0

    private fun call(service: String, arguments: JsonObject): CompletableFuture<JsonObject> {
        val id = "argo-api-${number.incrementAndGet()}"
        return CompletableFuture<JsonObject>().also {
            calls[id] = it
            it.whenComplete { _, _ -> calls -= id }
            send(Outgoing(operation("call_service", "id" to id, "service" to service, "args" to arguments)))
        }
    }

    /** Takes in what a bridge has said at [nowNanos]; false: it is no answer to a question of this object. */
    fun heard(operation: JsonObject, nowNanos: Long): Boolean {
        val id = operation.text("id")?.takeIf { operation.text("op") == "service_response" } ?: return false
        val call = calls[id] ?: return false
        val values = operation.part("values")
        if (values == null || operation.flag("result") == false) call.completeExceptionally(NotKnown())
        else call.complete(JsonObject(values + (RECEIVED to JsonPrimitive(nowNanos))))
        return true
    }

    /**
     * Begins to ask for the time, and checks the fields that [mapping] uses.
     *
     * @param limitMs how long the bridge has to describe its types; what it has not described by then is not checked
     * @throws MappingException if a field is none
     */
    fun check(mapping: Mapping, limitMs: Long) {
        askForTime()
        val types = mapping.percepts.map { it.type }.distinct()
        val described = types.associateWith { call("/rosapi/message_details", JsonObject(mapOf("type" to JsonPrimitive(it)))) }
        val end = clock.nanos() + TimeUnit.MILLISECONDS.toNanos(limitMs)
        val known = described.mapValues { (type, answer) -> fieldsOf(answer, type, end - clock.nanos()) }
        val problems = mapping.percepts.flatMap { rule ->
            val fields = known[rule.type] ?: return@flatMap emptyList()
            rule.fields().mapNotNull { field ->
                try {
                    checkField(field, rule.type, fields)
                    null
                } catch (refusal: Refusal) {
                    Problem(mapping.source, refusal.place.line, refusal.place.column, refusal.message.orEmpty())
                }
            }
        }
        if (problems.isNotEmpty()) throw MappingException(problems)
    }

    private fun fieldsOf(answer: CompletableFuture<JsonObject>, type: String, nanos: Long): Set<String>? = try {
        val definitions = answer.get(maxOf(0, nanos), TimeUnit.NANOSECONDS)["typedefs"] as? JsonArray
        val own = definitions?.filterIsInstance<JsonObject>()?.find { it.text("type")?.replace("/msg/", "/") == type.replace("/msg/", "/") }
        (own?.get("fieldnames") as? JsonArray)?.mapNotNull { (it as? JsonPrimitive)?.content }?.toSet()?.takeIf { it.isNotEmpty() }
    } catch (_: ExecutionException) {
        null
    } catch (_: TimeoutException) {
        null.also { answer.cancel(false) }
    }

    /** Asks for the time if it is due. */
    fun renew() {
        if (dueNanos?.let { clock.nanos() - it >= 0 } == true) askForTime()
    }

    private fun askForTime() {
        dueNanos = null
        askedNanos = clock.nanos()
        call("/rosapi/get_time", JsonObject(emptyMap())).thenAccept { answer ->
            val received = answer.text(RECEIVED)?.toLong() ?: return@thenAccept
            val ros = answer.part("time")?.rosNanos() ?: return@thenAccept
            offset.add(askedNanos, ros, received)
            answers++
            dueNanos = received + if (answers < FIRST_ANSWERS) FIRST_INTERVAL_NANOS else INTERVAL_NANOS
            if (answers >= FIRST_ANSWERS) report()
        }
    }

    private fun report() {
        val now = offset.offsetNanos ?: return
        if (toldNanos?.let { Math.abs(it - now) < CHANGE_NANOS } == true) return
        toldNanos = now
        val wall = TimeUnit.MILLISECONDS.toNanos(System.currentTimeMillis()) - clock.nanos()
        val aheadMs = TimeUnit.NANOSECONDS.toMillis(now - wall)
        val side = if (aheadMs < 0) "behind" else "ahead of"
        val errorMs = maxOf(1, TimeUnit.NANOSECONDS.toMillis(offset.errorNanos))
        tell("the robot's clock is ${Math.abs(aheadMs)} ms $side this computer's, give or take $errorMs ms; ages go by its time stamps")
    }

    override fun close() {
        dueNanos = null
        calls.values.toList().forEach { it.completeExceptionally(NotKnown()) }
    }

    private class NotKnown : Exception()

    private companion object {
        const val RECEIVED = "argo_received"
        const val FIRST_ANSWERS = 4
        val FIRST_INTERVAL_NANOS = TimeUnit.MILLISECONDS.toNanos(50)
        val INTERVAL_NANOS = TimeUnit.SECONDS.toNanos(10)
        val CHANGE_NANOS = TimeUnit.MILLISECONDS.toNanos(50)
    }
}
