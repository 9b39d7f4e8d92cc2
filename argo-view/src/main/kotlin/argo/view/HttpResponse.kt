package argo.view

import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json

/**
 * The response to a request.
 *
 * @property allow the resource's methods, if the request used another method
 * @property location the resource's address, if it is elsewhere
 */
internal class HttpResponse(
    val status: Int, val type: String, val body: ByteArray, val allow: String? = null, val location: String? = null,
) {
    companion object {
        inline fun <reified T> json(value: T, status: Int = 200, allow: String? = null) =
            HttpResponse(status, JSON, Json.encodeToString(value).toByteArray(), allow)

        /** Makes a response with [message] for a person: `{"message": …}`. */
        fun message(status: Int, message: String, allow: String? = null) = json(Message(message), status, allow)

        /** Refuses a request to a resource that has only the method [allowed]. */
        fun wrongMethod(allowed: String) = message(405, "use $allowed here", allowed)

        fun seeOther(location: String) = HttpResponse(303, "text/plain", ByteArray(0), location = location)

        /** The content type of JSON requests and responses. */
        const val JSON = "application/json"
    }

    @Serializable
    private class Message(val message: String)
}
