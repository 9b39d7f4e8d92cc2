package argo.recording.recorder

import argo.recording.End
import argo.recording.FilterChange
import argo.recording.Input
import argo.recording.Mail
import argo.recording.PerceivedSnapshot
import argo.recording.PerceptChange
import argo.recording.agent.laterText
import argo.recording.agent.literalText
import jason.asSyntax.Literal

/** What has entered an agent in a cycle. Belongs to the agent's thread; from the end of the cycle on to the thread that stores it. */
internal class CycleNotes(val ns: Long) {
    var counters: List<Int>? = null
    var events: List<String> = emptyList()
    var eventPlaces: Map<Int, Int> = emptyMap()
    val snapshots = ArrayList<PerceivedSnapshot>()
    var percepts: PerceptNote? = null
    var isOfSeveralBoards = false
    var critical: List<String> = emptyList()
    val boards = LinkedHashMap<String, String>()
    val mail = ArrayList<Mail>()
    val ends = ArrayList<End>()
    val sleep = StringBuilder()
    val calls = ArrayList<CallNote>()
    val filters = ArrayList<FilterChange>()
    var isChangedOutside = false

    /** The call that is being carried out; null: none is. */
    var underWay: CallNote? = null

    /** True if the cycle has work from those before it: one that only clears away an intention that has ended shows nothing else. */
    var isAtWork = false

    /** True if a message is on its way. */
    var isSending = false

    /** The cycle is over. */
    fun end() = calls.forEach(CallNote::end)

    /** Returns true if nothing has entered the agent. */
    fun isNothing() = events.isEmpty() && percepts == null && mail.isEmpty() && ends.isEmpty() && calls.isEmpty() && critical.isEmpty() &&
        filters.isEmpty() && !isChangedOutside

    /** What has entered it, once the cycle is over. */
    fun input() = Input(
        events, snapshots, percepts?.change(), isOfSeveralBoards, boards, critical,
        mail, ends, "$sleep", calls.map(CallNote::call), filters, isChangedOutside, eventPlaces,
    )
}

/** How percepts differ from those before, see [PerceptChange]. Jason believes copies of them, in which it shares sets and maps. */
internal class PerceptNote(private val keep: Int, private val now: List<Literal>, private val keepLast: Int) {
    private val texts = laterText(now) { now.map(::literalText) }

    val size: Int get() = now.size

    fun change() = PerceptChange(keep, texts(), keepLast)
}
