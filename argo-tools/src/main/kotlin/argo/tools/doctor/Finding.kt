package argo.tools.doctor

/**
 * One thing that was looked at.
 *
 * @property remedy what to do about it; null: nothing
 */
internal data class Finding(val level: Level, val what: String, val remedy: String? = null) {
    /** How it stands. */
    enum class Level {
        GOOD,

        /** It stands in the way of something that not everybody wants. */
        WARNING,

        /** It stands in the way of boards. */
        PROBLEM,
    }
}
