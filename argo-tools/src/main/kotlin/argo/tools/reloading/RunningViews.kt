package argo.tools.reloading

import argo.tools.command.ToolException
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import java.io.IOException
import java.net.ConnectException
import java.net.URI
import java.net.URLEncoder
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpRequest.BodyPublishers
import java.net.http.HttpResponse.BodyHandlers
import java.net.http.HttpTimeoutException
import java.time.Duration

/** The live views of a running program's agents, at [port] on this computer. */
internal class RunningViews(private val port: Int) {
    val address: URI = URI("http://127.0.0.1:$port/")
    private val client = HttpClient.newBuilder().connectTimeout(LIMIT).build()

    /**
     * Returns the names of the agents.
     *
     * @throws ToolException if no live view responds
     */
    fun agents(): List<String> = answer(request("agents")).second.getValue("agents").jsonArray.map { it.jsonPrimitive.content }

    /**
     * Makes [agent] reload its program and filters.
     *
     * @throws ToolException if no live view responds
     */
    fun reload(agent: String): Reloading {
        val path = URLEncoder.encode(agent, Charsets.UTF_8).replace("+", "%20") + "/reload"
        val (status, answer) = answer(request(path).header("Content-Type", "application/json").POST(BodyPublishers.ofString("{}")))
        return Reloading(status == DONE, answer.getValue("message").jsonPrimitive.content)
    }

    private fun request(path: String) = HttpRequest.newBuilder(address.resolve("/$path")).timeout(LIMIT)

    private fun answer(request: HttpRequest.Builder): Pair<Int, JsonObject> {
        val response = try {
            client.send(request.build(), BodyHandlers.ofString())
        } catch (trouble: IOException) {
            val why = when (trouble) {
                is HttpTimeoutException -> "nothing came within ${LIMIT.toSeconds()} s"
                is ConnectException -> "nothing listens there"
                else -> "nothing there answers in HTTP"
            }
            throw ToolException(
                "no live view responds at $address ($why): does the program run, with argo_view=$port beside its agent? " +
                    "--view PORT names another port",
            )
        }
        return try {
            response.statusCode() to Json.decodeFromString<JsonObject>(response.body())
        } catch (_: SerializationException) {
            throw ToolException("$address is no live view of this version of ARGO; --view PORT names another port")
        }
    }

    private companion object {
        const val DONE = 200

        /** The longest wait for a response. A view waits up to three seconds for its agent. */
        val LIMIT: Duration = Duration.ofSeconds(10)
    }
}

/**
 * The outcome of a reload.
 *
 * @property isDone true if the agent runs the current files
 * @property words the changes, or the reason why there are none
 */
internal class Reloading(val isDone: Boolean, val words: String)
