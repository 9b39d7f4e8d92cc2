package argo.check.rules

internal object ArgoActions {
    val NAMES = setOf("port", "ports", "limit", "percepts", "act", "age", "skew", "can", "change_filter", "explain", "record", "reload")

    /** The names that programs may write with a leading dot and no package. */
    val DOT_NAMES = NAMES + "filter"

    /** The actions that need `argo.Arch`. */
    val OF_BOARDS = setOf("port", "ports", "limit", "percepts", "act", "age", "skew", "can", "record", "reload")

    val ERRORS = setOf(
        "wrong_arguments", "not_argo", "no_such_port", "port_busy", "port_permission", "port_failed", "too_many_ports", "no_port",
        "port_gone", "port_timeout", "act_refused", "act_failed", "act_unconfirmed", "act_timeout", "act_replaced", "no_answer",
        "other_answer", "no_vocabulary", "not_perceived", "unknown_board", "not_recording", "ambiguous_action", "no_such_filter",
        "bad_filter", "bad_program",
    )

    /** The errors of `.send`, `.broadcast` and `.kill_agent` in a fleet. */
    private val FLEET_ERRORS = setOf(
        "no_agent", "unreachable", "overloaded", "not_sendable", "not_readable", "moved", "not_sender", "not_killed", "refused",
    )

    val JASON_ERRORS = setOf(
        "no_relevant", "no_applicable", "no_option", "constraint_failed", "ia_failed", "action_failed", "internal_action", "unknown",
        "wrong_arguments",
        "deadline_reached", "testing_goal_failed", "receiver_not_found",
    ) + FLEET_ERRORS

    /**
     * Returns the ARGO action that a call such as `.argo.port` means, or null if it means none. Ignores case. Jason may still not find
     * [called]; [exists] tells.
     */
    fun actionIn(called: String): String? {
        val name = called.removePrefix(".")
        return when {
            name.startsWith("argo.", ignoreCase = true) -> name.substringAfter('.')
            called != name && name.lowercase() in DOT_NAMES -> name
            else -> null
        }
    }

    /** Returns true if Jason finds an internal action of ARGO under the name [called]. */
    fun exists(called: String): Boolean =
        called.removePrefix(".argo.").removePrefix(".") in DOT_NAMES || called.removePrefix("argo.") in NAMES
}
