package argo.view

import kotlinx.serialization.Serializable
import kotlinx.serialization.json.Json

/**
 * What a request is answered with.
 *
 * @property allow the methods there are, if another was used
 */
internal class Answer(val status: Int, val type: String, val body: ByteArray, val allow: String? = null) {
    companion object {
        /** [json], as it is. */
        fun json(status: Int, json: String, allow: String? = null) = Answer(status, "application/json", json.toByteArray(), allow)

        /** Done, or refused, with [words] for a person to read. */
        fun said(status: Int, words: String, allow: String? = null) = json(status, Json.encodeToString(Words.serializer(), Words(words)), allow)

        /** The resource knows [allowed] only. */
        fun wrongMethod(allowed: String) = said(405, "use $allowed here", allowed)
    }

    @Serializable
    private class Words(val words: String)
}
