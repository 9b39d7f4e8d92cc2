package argo.check.project

import argo.check.syntax.Literal

/** Finds arguments of internal actions that have another role than [Role.DATA]. */
internal object SpecialArguments {
    /** Returns the roles of these arguments in [call], by index from 0. */
    fun of(call: Literal): Map<Int, Role> = when (call.functor) {
        ".send" -> contentOf(call, performative = 1)
        ".broadcast" -> contentOf(call, performative = 0)
        else -> ROLES[call.functor].orEmpty()
    }

    private fun contentOf(call: Literal, performative: Int): Map<Int, Role> {
        val role = PERFORMATIVES[(call.arguments.getOrNull(performative) as? Literal)?.functor] ?: return emptyMap()
        return mapOf(performative + 1 to role)
    }

    /** The role of a message's content for the receiver, by performative. */
    private val PERFORMATIVES = mapOf(
        "tell" to Role.TOLD, "untell" to Role.DELETED, "achieve" to Role.SENT_GOAL, "unachieve" to Role.SENT_GOAL, "askOne" to Role.ASKED,
        "askAll" to Role.ASKED, "signal" to Role.TOLD,
    )

    private val ROLES: Map<String, Map<Int, Role>> = buildMap {
        listOf(".findall", ".setof").forEach { put(it, mapOf(1 to Role.READ)) }
        listOf(".count", ".belief", ".if_then_else", ".foreach", ".loop").forEach { put(it, mapOf(0 to Role.READ)) }
        put(".eval", mapOf(1 to Role.READ))
        put(".abolish", mapOf(0 to Role.DELETED))
        listOf(".asserta", ".assertz", ".signal").forEach { put(it, mapOf(0 to Role.BELIEVED)) }
        listOf(".wait", ".relevant_plan", ".relevant_plans").forEach { put(it, mapOf(0 to Role.EVENT)) }
        put(".add_plan", mapOf(0 to Role.HANDLED))
        put(".at", mapOf(1 to Role.POSTED))
        listOf(
            ".desire", ".intend", ".drop_desire", ".drop_intention", ".drop_event", ".drop_future_intention", ".succeed_goal", ".fail_goal",
            ".done", ".suspend", ".suspended", ".resume",
        ).forEach { put(it, mapOf(0 to Role.NAMED_GOAL)) }
        listOf("argo.age", "argo.explain", ".argo.age", ".argo.explain", ".age", ".explain").forEach { put(it, mapOf(0 to Role.READ)) }
    }
}
