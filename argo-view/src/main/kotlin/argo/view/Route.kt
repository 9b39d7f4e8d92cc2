package argo.view

import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit

/** Responds to requests for one path by [respond], if they use [method]. */
internal class Route(val method: String, val respond: (Request) -> HttpResponse) {
    companion object {
        /** The largest request body that is read, in bytes. */
        const val MAX_BYTES = 10_000

        /** How long a request waits for an agent, in s. */
        const val MAX_WAIT_S = 3L

        fun get(respond: (Request) -> HttpResponse) = Route("GET", respond)

        /** Makes a route for requests with a [T] in JSON as their body. */
        inline fun <reified T> post(crossinline respond: (T) -> HttpResponse) = Route("POST") { request ->
            refusal(request) ?: try {
                respond(Json.decodeFromString<T>(request.body.decodeToString()))
            } catch (wrong: SerializationException) {
                HttpResponse.message(400, "the request cannot be read: ${wrong.message.orEmpty().lineSequence().first()}")
            }
        }

        fun refusal(request: Request): HttpResponse? = when {
            request.type?.substringBefore(';')?.trim() != HttpResponse.JSON -> // an HTML form cannot send JSON
                HttpResponse.message(415, "the request must be JSON, of type ${HttpResponse.JSON}")
            request.body.size > MAX_BYTES -> HttpResponse.message(413, "the request is longer than $MAX_BYTES bytes")
            else -> null
        }

        /**
         * Lets an agent do something, and returns its answer. If there is no answer within [MAX_WAIT_S] s, responds with [later]. The
         * agent's thread may be busy, or may not run yet.
         */
        fun awaited(
            later: String = "asked for; the agent does it in its next reasoning cycle, which has not come for $MAX_WAIT_S s",
            ask: (answer: (HttpResponse) -> Unit) -> Unit,
        ): HttpResponse {
            val answer = CompletableFuture<HttpResponse>()
            ask(answer::complete)
            return answer.completeOnTimeout(HttpResponse.message(202, later), MAX_WAIT_S, TimeUnit.SECONDS).join()
        }
    }
}
