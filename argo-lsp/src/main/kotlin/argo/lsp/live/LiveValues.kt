package argo.lsp.live

import com.google.gson.JsonObject
import com.google.gson.JsonParseException
import com.google.gson.JsonParser
import java.io.IOException
import java.io.UncheckedIOException
import java.net.URI
import java.net.URLEncoder
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.time.Duration
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ExecutionException
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException

/** Gets an agent's current percepts and beliefs from the agent's live view on this computer. */
internal class LiveValues(private val limit: Duration = Duration.ofMillis(LIMIT_MS)) {
    private val client by lazy { HttpClient.newBuilder().connectTimeout(limit).build() }

    /**
     * Returns the newest percepts with this [functor] and [arity]. If there are none, returns beliefs with this [functor] and [arity].
     * Returns an empty list if [agent] has no view at [port].
     */
    fun of(port: Int, agent: String, functor: String, arity: Int): List<String> {
        val state = state(port, agent) ?: return emptyList()
        fun texts(part: String, list: String) = state.getAsJsonObject(part)?.getAsJsonArray(list)?.map { it.asJsonObject }.orEmpty()
        val percepts = texts("sensors", "percepts").filter { it.isOf(functor, arity) }
            .map { "${it["text"].asString}, ${it["ageMs"].asLong} ms ago" }
        return percepts.ifEmpty { texts("beliefs", "beliefs").filter { it.isOf(functor, arity) }.map { it["text"].asString } }
            .take(MAX_SHOWN)
    }

    private fun JsonObject.isOf(functor: String, arity: Int): Boolean {
        val term = javino.PerceptTerm.of(this["text"].asString)
        return term.functor() == functor && term.arguments().size == arity
    }

    /** Returns the first state that the view would send to the agent's page. The view sends a state to each new page at once. */
    private fun state(port: Int, agent: String): JsonObject? {
        val path = URLEncoder.encode(agent, Charsets.UTF_8).replace("+", "%20")
        val request = HttpRequest.newBuilder(URI("http://127.0.0.1:$port/$path/events")).timeout(limit).build()
        val sent = client.sendAsync(request, HttpResponse.BodyHandlers.ofInputStream())
        val answer = sent.thenApplyAsync { response ->
            response.body().use { body ->
                body.bufferedReader().lineSequence().find { it.startsWith(DATA) }?.takeIf { response.statusCode() == OK }
            }
        }
        return get(answer) { sent.thenAccept { it.body().close() } }?.let(::objectOf)
    }

    /** Returns the object in [line]; null if another program has sent something else. */
    private fun objectOf(line: String): JsonObject? = try {
        JsonParser.parseString(line.removePrefix(DATA)).takeIf { it.isJsonObject }?.asJsonObject
    } catch (_: JsonParseException) {
        null
    }

    /**
     * Returns the answer; null if no agent runs, or if another program uses its port. If the answer does not come in time, calls [giveUp]:
     * a program that sends without end, such as a camera, would keep a thread.
     */
    private fun get(answer: CompletableFuture<String?>, giveUp: () -> Unit): String? = try {
        answer.get(limit.toMillis(), TimeUnit.MILLISECONDS)
    } catch (refused: ExecutionException) {
        if (refused.cause !is IOException && refused.cause !is UncheckedIOException) throw refused
        null
    } catch (_: TimeoutException) {
        giveUp()
        null
    }

    private companion object {
        /** The longest time for which a hover waits for values. */
        const val LIMIT_MS = 300L
        const val DATA = "data:"
        const val OK = 200
        const val MAX_SHOWN = 5
    }
}
