package argo.platform

import jason.asSemantics.Agent
import jason.asSyntax.Plan
import jason.asSyntax.Trigger
import java.lang.reflect.InvocationTargetException
import java.lang.reflect.Method

/**
 * The plan library of an agent in Jason.
 *
 * The library's class is in different packages in Jason 3.3.0 and 3.2.1, and compiled code can name only one of them. Therefore this class
 * calls the methods of both versions by reflection. No other code may name Jason's class. For the agent's thread.
 *
 * @property library Jason's own object
 */
class Plans private constructor(val library: Any) {
    /** The plans, in their order. */
    @Suppress("UNCHECKED_CAST")
    val all: List<Plan> get() = call(ALL, library) as List<Plan>

    /**
     * Returns a copy of the plans in their order. A plan that is being added at this moment may be missing. Any thread may call this
     * function.
     */
    fun copy(): List<Plan> = ArrayList<Plan?>(all).filterNotNull()

    /** Returns true if a plan may be relevant to an event with [trigger]. */
    fun hasCandidate(trigger: Trigger): Boolean = call(HAS_CANDIDATE, library, trigger) as Boolean

    /** Replaces all plans by [plans]. Throws [jason.JasonException] if one of them cannot be added. */
    fun replaceBy(plans: List<Plan>) {
        call(CLEAR, library)
        plans.forEach { call(ADD, library, it) }
    }

    /** True if a plan has the state of a goal as its trigger: `^!goal[state(S)]`. */
    val hasMetaEvents: Boolean get() = call(HAS_META_EVENTS, library) as Boolean

    companion object {
        private val OF_AGENT: Method = Agent::class.java.getMethod("getPL")
        private val OF_PLAN: Method = Plan::class.java.getMethod("getSubPlans")
        private val TYPE: Class<*> = OF_AGENT.returnType
        private val ALL = TYPE.getMethod("getPlans")
        private val HAS_CANDIDATE = TYPE.getMethod("hasCandidatePlan", Trigger::class.java)
        private val CLEAR = TYPE.getMethod("clear")
        private val HAS_META_EVENTS = TYPE.getMethod("hasMetaEventPlans")
        private val SET_OF_AGENT: Method = Agent::class.java.getMethod("setPL", TYPE)
        private val ADD = TYPE.getMethod("add", Plan::class.java)

        fun of(agent: Agent): Plans = Plans(checkNotNull(call(OF_AGENT, agent)))

        /** Returns the plans that [read] adds to [agent]. Then removes these plans from the agent. */
        fun readInto(agent: Agent, read: () -> Unit): List<Plan> {
            val before = of(agent)
            val empty = TYPE.getConstructor().newInstance()
            call(SET_OF_AGENT, agent, empty)
            try {
                read()
            } finally {
                call(SET_OF_AGENT, agent, before.library)
            }
            return Plans(empty).all
        }

        /** Returns the plans written inside [plan]; null if there are none. */
        fun within(plan: Plan): Plans? = call(OF_PLAN, plan)?.let(::Plans)

        fun isLibrary(one: Any): Boolean = TYPE.isInstance(one)

        private fun call(method: Method, on: Any, vararg arguments: Any): Any? = try {
            method.invoke(on, *arguments)
        } catch (failed: InvocationTargetException) {
            throw failed.targetException
        }
    }
}
