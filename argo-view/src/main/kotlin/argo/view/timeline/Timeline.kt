package argo.view.timeline

import argo.recording.Mail
import argo.recording.replay.Recording
import kotlinx.serialization.Serializable
import java.time.Duration

/** The part of a lane between two times, for the page, with [items] or, if there are too many, [heaps]. */
@Serializable
internal class LanePart(val agent: Int, val lane: Lane, val items: List<Item> = emptyList(), val heaps: List<Heap> = emptyList())

/** [count] items that are too close together to be drawn one by one. [id] is the first failure or, if there is none, the first item. */
@Serializable
internal class Heap(val from: Double, val until: Double, val count: Int, val isBad: Boolean, val id: Int)

/** An item with its causes and its effects, the nearest first. */
@Serializable
internal class Related(val item: Item, val causes: List<Item>, val effects: List<Item>)

/**
 * The items of a recording's agents, with their causes. Immutable.
 *
 * @property agents the names of the agents
 * @property seconds the length of the recording
 * @property items all items; the index of an item in this list is its id
 */
internal class Timeline(val agents: List<String>, val seconds: Double, val items: List<Item>) {
    private val lanes: Map<Pair<Int, Lane>, List<Item>> =
        items.groupBy { it.agent to it.lane }.mapValues { (_, items) -> items.sortedBy { it.from } }
    private val longest: Map<Pair<Int, Lane>, Double> =
        lanes.mapValues { (_, items) -> items.maxOf { (it.until ?: it.from) - it.from } }
    private val effects: Map<Int, List<Int>> =
        items.flatMap { item -> item.causes.map { it to item.id } }.groupBy({ it.first }, { it.second })

    /** Returns the lanes from [from] to [until], in seconds. If a lane has more than [most] items, it has at most [most] heaps instead. */
    fun between(from: Double, until: Double, most: Int): List<LanePart> =
        lanes.entries.sortedBy { (key, _) -> key.first * Lane.entries.size + key.second.ordinal }.map { (key, all) ->
            val first = all.firstFrom(from - longest.getValue(key))
            val some = all.subList(first, maxOf(first, all.firstFrom(until, isAfter = true))).filter { (it.until ?: it.from) >= from }
            val (agent, lane) = key
            if (some.size <= most) LanePart(agent, lane, some) else LanePart(agent, lane, heaps = heaps(some, from, until, most))
        }

    private fun heaps(items: List<Item>, from: Double, until: Double, most: Int): List<Heap> {
        val width = (until - from) / most
        return items.groupBy { ((it.from - from) / width).toInt() }.values.map { heap ->
            val bad = heap.find { it.isBad }
            Heap(heap.first().from, heap.last().from, heap.size, bad != null, (bad ?: heap.first()).id)
        }
    }

    /** Returns the item [id] with at most [most] links in each direction; null if no item has this id. */
    fun related(id: Int, most: Int): Related? {
        val item = items.getOrNull(id) ?: return null
        return Related(item, reached(id, most) { items[it].causes }, reached(id, most) { effects[it].orEmpty() })
    }

    /** Returns the id of the item for command [number] of [agent]; null if the timeline has none. */
    fun command(agent: String, number: Long): Int? {
        val place = agents.indexOf(agent)
        return lanes[place to Lane.COMMANDS]?.find { it.command == number }?.id
    }

    /** Returns the item before or after [id] in its lane, or [id] itself if none is there. */
    fun beside(id: Int, isAfter: Boolean): Int? {
        val item = items.getOrNull(id) ?: return null
        val lane = lanes.getValue(item.agent to item.lane)
        return (lane.getOrNull(lane.indexOf(item) + if (isAfter) 1 else -1) ?: item).id
    }

    private fun reached(from: Int, most: Int, next: (Int) -> List<Int>): List<Item> {
        val reached = linkedSetOf(from)
        val open = ArrayDeque(listOf(from))
        while (open.isNotEmpty() && reached.size <= most) {
            for (id in next(open.removeFirst())) if (reached.size <= most && reached.add(id)) open += id
        }
        return reached.drop(1).map(items::get)
    }

    /** Returns the index of the first item that begins at [time] or later. With [isAfter], it must be later than [time]. */
    private fun List<Item>.firstFrom(time: Double, isAfter: Boolean = false): Int =
        binarySearch { if (it.from < time || isAfter && it.from == time) -1 else 1 }.let { -it - 1 }

    companion object {
        /** Reads [recording], or only its [last] part. Throws [IllegalArgumentException] if a recorded message cannot be read. */
        fun of(recording: Recording, last: Duration? = null): Timeline = ofAll(listOf(recording), listOf(0), last)

        /**
         * Reads [recordings] of several programs, such as those on the computers of a fleet.
         *
         * @param aheadNs for each recording, how far its clock is ahead of the first recording's clock, in ns
         */
        fun ofAll(recordings: List<Recording>, aheadNs: List<Long>, last: Duration? = null): Timeline {
            val all = recordings.flatMapIndexed { place, one -> one.agents.keys.sorted().map { Recorded(it, one, aheadNs[place]) } }
            val zeroNs = all.mapNotNull { it.firstNs(last) }.minOrNull() ?: 0
            val items = ArrayList<Item>()
            val made = all.mapIndexed { place, agent -> agent to agent.read(place, zeroNs, items, last) }
            made.forEach { (agent, its) ->
                its.taken.forEach { (id, mail) -> sendingOf(mail, agent, made)?.let { items[id] = items[id].causedBy(it) } }
            }
            return Timeline(all.map { it.name }, items.maxOfOrNull { it.until ?: it.from } ?: 0.0, items)
        }

        /**
         * Returns the step that sent [mail] to an agent. If this agent's recording has an agent with the sender's name, this is the sender.
         */
        private fun sendingOf(mail: Mail, to: Recorded, made: List<Pair<Recorded, AgentItems>>): Int? {
            val senders = made.filter { (agent) -> agent.name == mail.sender }
            val own = senders.filter { (agent) -> agent.recording === to.recording }
            return own.ifEmpty { senders }.firstNotNullOfOrNull { (_, items) -> items.sent[mail.id] }
        }
    }

    /** An agent of a [recording]. The recording's clock is [aheadNs] ahead. */
    private class Recorded(val name: String, val recording: Recording, private val aheadNs: Long) {
        fun firstNs(last: Duration?): Long? = recording.cycles(name, last).firstOrNull()?.let { it.ns - aheadNs }

        fun read(place: Int, zeroNs: Long, items: MutableList<Item>, last: Duration?): AgentItems {
            val made = AgentItems(place, zeroNs + aheadNs, items, recording.commandEnds(name, last).associateBy { it.number })
            recording.cycles(name, last).forEach(made::add)
            return made
        }
    }
}
