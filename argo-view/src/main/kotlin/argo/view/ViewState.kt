package argo.view

import kotlinx.serialization.Serializable

/**
 * The content of a page at one moment. Times are ages in ms. Long lists are cut, and the state then has the number of left-out entries.
 *
 * @property intervalMs the sensing interval of boards without their own interval
 * @property skewMs the time between the oldest and the newest reading; null if the agent perceives fewer than two boards
 * @property printed the agent's printed lines, the latest first
 * @property courses the [RecentNumbers.values] of sensors during the last minute, by [PerceptState.key]; null if unchanged
 * @property moreCritical the number of critical rules left out of [critical]
 * @property agents the agents with a view on this server
 * @property moreAgents the number of agents left out of [agents]
 * @property computers the computers of the system; empty if the system is on one computer
 * @property breakpoints the lines at which pages make the agent stop
 * @property waitingToStart whether the agent has not run a reasoning cycle yet
 */
@Serializable
internal data class ViewState(
    val agent: String,
    val policy: String,
    val intervalMs: Int,
    val skewMs: Long?,
    val perceiving: Boolean,
    val waitingToStart: Boolean,
    val ended: Boolean,
    val filter: FilterState?,
    val critical: List<CriticalState>,
    val moreCritical: Int,
    val ports: List<PortState>,
    val sensors: SensorState,
    val beliefs: BeliefsState,
    val commands: CommandsState,
    val rates: Rates?,
    val picture: PictureState?,
    val intentions: IntentionsState,
    val printed: List<LineState>,
    val courses: Map<String, List<List<Double?>>>?,
    val agents: List<AgentTab>,
    val moreAgents: Int,
    val computers: List<ComputerState>,
    val pause: PauseState,
    val breakpoints: List<BreakpointState>,
)

/**
 * A computer of the system.
 *
 * @property near whether a browser on this computer can open the other computer's live views
 * @property agents the first of the computer's agents
 * @property more the number of the computer's other agents
 */
@Serializable
internal data class ComputerState(
    val name: String,
    val address: String,
    val here: Boolean,
    val near: Boolean,
    val on: Boolean,
    val agents: List<AgentState>,
    val more: Int,
)

/**
 * An agent on a computer.
 *
 * @property viewPort the port of the agent's live view on its computer; null if there is no view or no fixed port
 */
@Serializable
internal data class AgentState(val name: String, val viewPort: Int?)

/**
 * Whether the agent runs.
 *
 * @property phase `running`, `making_safe` while its boards are made safe, or `paused`
 * @property words why the agent is paused, and the result of making its boards safe, in lines
 * @property intention the number of the intention in which the agent is paused; null if it is not paused within an intention
 */
@Serializable
internal data class PauseState(val phase: String, val words: String, val intention: Int?)

@Serializable
internal data class FilterState(val name: String, val words: String)

/**
 * A critical rule of the active filter.
 *
 * @property rule the rule and its reflex in words
 * @property watcher `board` or `computer`
 * @property reflex the reflex's last outcome, `done` or `failed`; null if there is none yet
 * @property by `board` or `computer`: which of them started the reflex
 * @property ageMs the age of the outcome
 * @property error the reason of the reflex's failure
 */
@Serializable
internal data class CriticalState(
    val rule: String,
    val watcher: String,
    val reflex: String?,
    val by: String?,
    val ageMs: Long?,
    val error: String?,
)

/**
 * A port.
 *
 * @property stale whether no message comes from the port although the agent perceives
 * @property perceived whether the agent perceives the port's board
 * @property namespace the namespace of the percepts of the port's board; null for the default namespace
 * @property intervalMs the sensing interval of the port's board; null if the board is not perceived
 * @property filter the name of the board's filter; null if there is none
 * @property reason the reason why the port is not on, if known
 * @property ageMs the time since the last change of [status]
 */
@Serializable
internal data class PortState(
    val name: String,
    val status: String,
    val inUse: Boolean,
    val stale: Boolean,
    val perceived: Boolean,
    val namespace: String?,
    val intervalMs: Int?,
    val filter: String?,
    val reason: String?,
    val ageMs: Long?,
)

/**
 * The percepts of the boards, and the times of the newest message and perception.
 *
 * @property frameAgeMs the age of the newest message; null if no message has come
 * @property handedOverAgeMs the time since the agent last perceived a message; null if it has perceived none
 * @property delayMs the age of the last perceived message at its perception
 * @property more the number of percepts left out of [percepts]
 * @property moreCourses the number of sensors with numbers but without a shown course
 */
@Serializable
internal data class SensorState(
    val frameAgeMs: Long?,
    val handedOverAgeMs: Long?,
    val delayMs: Long?,
    val percepts: List<PerceptState>,
    val more: Int,
    val moreCourses: Int,
)

/**
 * A percept as it came off the line.
 *
 * @property key identifies the sensor; readings of one sensor differ only in numbers
 * @property board the namespace of the percept's board; null if there is none
 * @property fate `kept`, `dropped`, `held` (back), or `unreadable` if the filter keeps it but it is not a percept
 * @property silent whether the board is silent
 * @property ageMs the time since the percept last came
 * @property sameMs the time since the percept last changed
 * @property described the percept, compared with the board's description; null if the board describes no percepts
 */
@Serializable
internal data class PerceptState(
    val key: String,
    val board: String?,
    val text: String,
    val fate: String,
    val silent: Boolean,
    val ageMs: Long,
    val sameMs: Long,
    val described: DescribedPercept?,
)

/**
 * The agent's beliefs.
 *
 * @property ageMs the age of this look at the belief base; null if there was none yet
 * @property total the number of all beliefs, including those left out of [beliefs]
 */
@Serializable
internal data class BeliefsState(val ageMs: Long?, val total: Int, val beliefs: List<Belief>)

/**
 * A belief, or a rule.
 *
 * @property sources `percept`, `self` or agents
 * @property whole the belief with its sources, for the button that forgets it; null for a percept, a rule, or a long belief
 */
@Serializable
internal data class Belief(val text: String, val sources: List<String>, val whole: String?)

/** The agent's intentions. [total] also counts those left out of [intentions]. */
@Serializable
internal data class IntentionsState(val total: Int, val intentions: List<IntentionState>)

/**
 * An agent on this server.
 *
 * @property name the agent's name; its page is at `/NAME/`
 * @property silent whether a board that the agent perceives is silent
 */
@Serializable
internal data class AgentTab(val name: String, val silent: Boolean)

/**
 * The agent's commands. [unfinished] has those that have not gone out, the oldest first. [finished] has the others, the newest first.
 *
 * @property waiting the number of all commands that have not gone out, including those left out of [unfinished]
 */
@Serializable
internal data class CommandsState(val waiting: Int, val unfinished: List<CommandState>, val finished: List<CommandState>)

/**
 * A command.
 *
 * @property number the command's number; it does not change while the command is shown
 * @property times the number of equal commands in a row; the other properties are about the last of them
 * @property state one of `line` (the next command of its port), `waiting`, `done` and `failed`
 * @property ageMs the time since the command was issued
 * @property tookMs the time from the issue to the outcome
 * @property error the reason of the failure
 * @property last the agent's number of the last of these equal commands
 */
@Serializable
internal data class CommandState(
    val number: Long,
    val port: String,
    val text: String,
    val times: Int,
    val state: String,
    val ageMs: Long,
    val tookMs: Long?,
    val error: String?,
    val last: Long,
)

/** Rates of events, per second. */
@Serializable
internal data class Rates(val frames: Double, val handOvers: Double, val commands: Double, val cycles: Double)

@Serializable
internal data class PictureState(val svg: String, val words: String)

internal fun shown(text: String): String = if (text.length <= MAX_CHARACTERS) text else text.take(MAX_CHARACTERS) + "…"

private const val MAX_CHARACTERS = 300
