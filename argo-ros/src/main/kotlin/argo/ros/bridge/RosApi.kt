package argo.ros.bridge

import argo.filters.Problem
import argo.ros.mapping.CommandRule
import argo.ros.mapping.Mapping
import argo.ros.mapping.MappingException
import argo.ros.mapping.Refusal
import argo.ros.mapping.checkField
import argo.ros.mapping.fields
import argo.ros.mapping.isRos2Action
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
 * Asks the node `rosapi`, which often runs beside a bridge, for the robot's time, for types, and for who publishes what. Where it does not
 * run, none of that is known. A bridge of ROS 1 reports no mistakes to its clients, so that asking is the only way to find them. Safe for
 * use by several threads.
 *
 * @param offset takes the times
 * @param send sends a message to the bridge
 * @param warn takes why nothing can come of a topic, or of a command
 * @param tell takes the offset of the clocks, for a person, when it is known and when it has changed much
 */
internal class RosApi(
    private val clock: LineClock,
    private val offset: ClockOffset,
    private val send: (Outgoing) -> Unit,
    private val warn: (String) -> Unit,
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
        if (values == null || operation.flag("result") == false) call.completeExceptionally(NotKnown(operation.text("values").orEmpty()))
        else call.complete(JsonObject(values + (RECEIVED to JsonPrimitive(nowNanos))))
        return true
    }

    /**
     * Begins to ask for the time and for the types of the topics in [mapping], and checks the fields that it uses.
     *
     * @param limitMs how long the bridge has to describe its types; what it has not described by then is not checked
     * @throws MappingException if a field is none
     */
    fun check(mapping: Mapping, limitMs: Long) {
        askForTime()
        val topics = mapping.percepts.map { it.topic to it.type } + mapping.commands.mapNotNull(::topicOf)
        topics.distinct().forEach { (topic, type) -> compareType(topic, type) }
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
        val own = definitions?.filterIsInstance<JsonObject>()?.find { rosType(it.text("type").orEmpty()) == rosType(type) }
        (own?.get("fieldnames") as? JsonArray)?.mapNotNull { (it as? JsonPrimitive)?.content }?.toSet()?.takeIf { it.isNotEmpty() }
    } catch (unknown: ExecutionException) {
        val reason = unknown.cause?.message.orEmpty().substringBefore("\\n") // then the paths that were searched
        if (reason.isNotEmpty() && MISSING !in reason) warn("the bridge does not know the type $type, so that nothing comes of it: $reason")
        null
    } catch (_: TimeoutException) {
        null.also { answer.cancel(false) }
    }

    /** The topic that [rule] publishes on, and its type; null: on none. */
    private fun topicOf(rule: CommandRule): Pair<String, String>? = when {
        rule.kind == CommandRule.Kind.TOPIC -> rule.target to rule.type
        rule.kind == CommandRule.Kind.ACTION && !isRos2Action(rule.type) -> "${rule.target}/goal" to "${rule.type}Goal"
        else -> null
    }

    /** Warns if [topic] has messages of another type than [type]; then the bridge passes none on, in either direction. */
    private fun compareType(topic: String, type: String) {
        call("/rosapi/topic_type", about(topic)).thenAccept { answer ->
            val known = answer.text("type").orEmpty()
            if (known.isEmpty() || rosType(known) == rosType(type)) return@thenAccept
            warn("$topic is of type $known on the robot, and the mapping says $type: its messages do not pass the bridge")
        }
    }

    /** [topic], of [type], has said nothing for long: warns if nothing can come of it. */
    fun explainSilence(topic: String, type: String) {
        compareType(topic, type)
        call("/rosapi/publishers", about(topic)).whenComplete { answer, trouble ->
            if (trouble == null && (answer["publishers"] as? JsonArray)?.isEmpty() == true) warn("no node publishes $topic")
            else if (MISSING in trouble?.message.orEmpty()) warn("nothing has come of $topic; does a node publish it?")
        }
    }

    private fun about(topic: String) = JsonObject(mapOf("topic" to JsonPrimitive(topic)))

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
        calls.values.toList().forEach { it.completeExceptionally(NotKnown("")) }
    }

    /** @param reason why, as the bridge has it; empty: it does not say */
    private class NotKnown(reason: String) : Exception(reason)

    /** [type] without what ROS 2 has between package and name. */
    private fun rosType(type: String) = type.replace("/msg/", "/")

    private companion object {
        const val RECEIVED = "argo_received"

        /** What bridges answer where `rosapi` does not run. */
        const val MISSING = "does not exist"
        const val FIRST_ANSWERS = 4
        val FIRST_INTERVAL_NANOS = TimeUnit.MILLISECONDS.toNanos(50)
        val INTERVAL_NANOS = TimeUnit.SECONDS.toNanos(10)
        val CHANGE_NANOS = TimeUnit.MILLISECONDS.toNanos(50)
    }
}
