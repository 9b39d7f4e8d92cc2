package argo.tools.doctor

/**
 * The result of one check.
 *
 * @property remedy null: none is needed
 */
internal data class Finding(val level: Level, val what: String, val remedy: String? = null) {
    enum class Level {
        GOOD,

        /** Something may fail that not everybody needs. */
        WARNING,

        /** Boards will not work. */
        PROBLEM,
    }
}
