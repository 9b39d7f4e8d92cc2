package argo.recording

import kotlinx.serialization.Serializable

/** The whole state of an agent at the end of a cycle. A replay can begin at this cycle. Immutable. */
@Serializable
data class KeyFrame(
    @Holds("the index of the cycle at whose end the agent was like this")
    val index: Long,
    @Holds("Jason's number of that cycle")
    val number: Int,
    @Holds("when that cycle began, in ns of the agent's clock")
    val ns: Long,
    @Holds("the reason why there is no key frame here, and no field but those above; missing: there is one")
    val missing: String? = null,
    @Holds("what the agent believes, in the order of its belief base")
    val beliefs: List<String> = emptyList(),
    @Holds("the rules of the program: the place of each among the beliefs, from 0, and its number in the program")
    val rules: Map<Int, Int> = emptyMap(),
    @Holds("the places among the beliefs, from 0, of those that are percepts, in the order in which Jason goes through them")
    val percepts: List<Int> = emptyList(),
    @Holds("the most percepts that there were at a time: that order depends on it")
    val mostPercepts: Int = 0,
    @Holds("what the agent perceived, in its order")
    val perceived: List<String> = emptyList(),
    @Holds("the filters that it perceives through")
    val filters: List<FilterChange> = emptyList(),
    @Holds("how many things it had begun outside of its thread")
    val begun: Int = 0,
    @Holds("the ends of its running timers, in ns of its clock, by the timers' numbers")
    val timers: Map<Int, Long> = emptyMap(),
    @Holds("how many intentions were counted")
    val intentions: Int = 0,
    @Holds("the number of cycles since it perceived last")
    val cyclesUnperceived: Int = 0,
    @Holds("whether Jason had reported it asleep")
    val isAsleep: Boolean = false,
    @Holds("how many plans and rules its program has")
    val parts: Int = 0,
    @Holds("its events, intentions and plans, as Java writes objects of Jason: deflated, in base 64")
    val mind: String = "",
)
