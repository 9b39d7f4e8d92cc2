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
        fun json(status: Int, json: String) = Answer(status, "application/json", json.toByteArray())

        /** Done, or refused, for a reason that the page shows. */
        fun said(status: Int, words: String) = json(status, Json.encodeToString(Words.serializer(), Words(words)))

        /** Refused for this reason. */
        fun problem(status: Int, reason: String) = said(status, reason)

        /** The resource knows [allowed] only. */
        fun wrongMethod(allowed: String) = Answer(405, "application/json", Json.encodeToString(Words.serializer(), Words("use $allowed here")).toByteArray(), allowed)
    }

    @Serializable
    private class Words(val words: String)
}
