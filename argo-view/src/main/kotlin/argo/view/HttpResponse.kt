package argo.view

import com.sun.net.httpserver.HttpExchange
import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json

/**
 * The response to a request.
 *
 * @property allow the methods of the resource, if another one was used
 * @property location the address of the resource, if it is elsewhere
 */
internal class HttpResponse(
    val status: Int, val type: String, val body: ByteArray, val allow: String? = null, val location: String? = null,
) {
    companion object {
        /** Makes a response with [message] for a person, as `{"message": …}`. */
        fun message(status: Int, message: String, allow: String? = null) =
            HttpResponse(status, JSON, Json.encodeToString(Message.serializer(), Message(message)).toByteArray(), allow)

        /** Refuses a request to a resource that has the method [allowed] only. */
        fun wrongMethod(allowed: String) = message(405, "use $allowed here", allowed)

        /** Leads the client to [location]. */
        fun seeOther(location: String) = HttpResponse(303, "text/plain", ByteArray(0), location = location)

        /** The content type of requests and responses. */
        const val JSON = "application/json"
    }

    @Serializable
    private class Message(val message: String)
}

/** Begins the response to an exchange with [status], content of [type] and so many bytes; see [HttpExchange.sendResponseHeaders]. */
internal fun HttpExchange.begin(status: Int, type: String, length: Long) {
    HEADERS.forEach { (name, value) -> responseHeaders.add(name, value) }
    responseHeaders.add("Content-Type", "$type; charset=utf-8")
    sendResponseHeaders(status, length)
}

private val HEADERS = mapOf(
    "Cache-Control" to "no-store",
    "Content-Security-Policy" to "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; " +
        "base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "Referrer-Policy" to "no-referrer",
    "X-Content-Type-Options" to "nosniff",
    "X-Frame-Options" to "DENY",
)
