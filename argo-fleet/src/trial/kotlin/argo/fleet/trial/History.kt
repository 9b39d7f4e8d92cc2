package argo.fleet.trial

/**
 * The history of a fleet from the notes of its programs. Without [faults], the fleet has kept these promises:
 *
 * - each message is taken at most once, only by its receiver, and the messages of a session in order;
 * - each message has one end, unless its sender crashed, and a message that is reported as taken was taken;
 * - an agent that outlives its computer never acts twice at a time.
 */
class History(events: List<Event>) {
    private data class Message(val session: String, val number: Long)
    private class Taking(val by: String, val message: Message)

    private val bySession = events.sortedBy { it.nanos }.groupBy { it.session }
    private val receivers = events.filter { it.kind == Kind.SENT }.associate { Message(it.session, it.about[1].toLong()) to it.about[0] }
    private val takings = bySession.values.flatten().filter { it.kind == Kind.TOOK }
        .map { Taking(it.session, Message(it.about[0], it.about[1].toLong())) }

    private val taken = takings.mapTo(HashSet()) { it.message }
    private val sent = receivers.keys.groupBy { it.session }

    fun count(kind: Kind): Int = bySession.values.sumOf { events -> events.count { it.kind == kind } }

    /** Each broken promise, in words. */
    fun faults(): List<String> =
        misled() + doubled() + disordered() + bySession.flatMap { (session, events) -> ends(session, events) } + twice()

    private fun misled() = takings.filter { it.by.substringBefore('#') != receivers[it.message] }
        .map { "${it.by} took ${it.message.text()}, which was sent to ${receivers[it.message] ?: "nobody"}" }

    private fun doubled() = takings.groupBy { it.message }.filterValues { it.size > 1 }
        .map { (message, by) -> "${message.text()} was taken ${by.size} times, by ${by.joinToString { it.by }}" }

    private fun disordered() = takings.groupBy { it.by to it.message.session }.flatMap { (pair, list) ->
        list.map { it.message.number }.zipWithNext().filter { (one, next) -> next < one }
            .map { (one, next) -> "${pair.first} took message $next of ${pair.second} behind message $one" }
    }

    private fun ends(session: String, events: List<Event>): List<String> {
        val ends = events.filter { it.kind == Kind.TAKEN || it.kind == Kind.FAILED }.groupBy { it.about[0].toLong() }
        val isComplete = events.any { it.kind == Kind.FINISHED }
        return sent[session].orEmpty().mapNotNull { message ->
            val found = ends[message.number].orEmpty().map { it.kind }
            when {
                found.size > 1 -> "${message.text()} ended ${found.size} times"
                found.isEmpty() && isComplete -> "${message.text()} had no end"
                found == listOf(Kind.TAKEN) && message !in taken -> "${message.text()} ended as taken, and nobody took it"
                else -> null
            }
        }
    }

    /** Finds agents that act in a reign after an action in a later reign. */
    private fun twice() = bySession.values.flatten().filter { it.kind == Kind.ACTED }.groupBy { it.about[0] }.flatMap { (agent, acts) ->
        val sorted = acts.sortedBy { it.nanos }
        val newest = sorted.runningReduce { before, act -> if (act.term > before.term) act else before }
        sorted.zip(newest).filter { (act, newest) -> act.term < newest.term }.map { (act, newest) ->
            "$agent acted on ${act.session} ${(act.nanos - newest.nanos) / NANOS_PER_MICRO} microseconds after its next reign, on " +
                "${newest.session}, had begun to act"
        }
    }

    private val Event.term get() = about[1].toLong()

    private fun Message.text() = "message $number of $session"

    private companion object {
        const val NANOS_PER_MICRO = 1000
    }
}
