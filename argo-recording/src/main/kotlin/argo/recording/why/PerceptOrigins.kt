package argo.recording.why

import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.filters.matching.OWN_BELIEFS
import argo.recording.PerceivedSnapshot
import argo.recording.agent.literalOf
import argo.recording.agent.literalText
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal

/** Finds the frames by which an agent's percepts came and went. */
internal class PerceptOrigins(private val secondsOf: (Long) -> Double, private val filterOf: (port: String, text: String) -> String?) {
    private val present = HashMap<String, PerceptCause>()
    private val gone = object : LinkedHashMap<String, PerceptCause>() {
        override fun removeEldestEntry(eldest: Map.Entry<String, PerceptCause>) = size > MAX_GONE
    }
    private val newest = LinkedHashMap<String, Frame>()
    private val frames = Frames(secondsOf)
    private val earlier = HashSet<String>()

    val newestFrames: Collection<Frame> get() = newest.values

    /** Begins with [percepts], which the agent perceives at the beginning of the replay. The frames of these percepts are not known. */
    fun beginWith(percepts: List<Literal>) {
        percepts.mapTo(earlier, ::keyOf)
    }

    /**
     * Notes that the agent perceives [percepts] in the cycle with this [number] at [ns]. New percepts come from [snapshots]. All other
     * percepts stay.
     */
    fun perceived(percepts: Collection<Literal>, snapshots: List<PerceivedSnapshot>, number: Int, ns: Long) {
        val seconds = secondsOf(ns)
        val now = snapshots.map { frames.of(it, number) to keysOf(it) }
        now.forEach { (frame, _) -> newest[frame.port] = frame }
        val keys = percepts.associateBy(::keyOf)
        earlier.retainAll(keys.keys)
        for ((key, percept) in keys) {
            if (key in present || key in earlier) continue
            val found = now.find { (_, kept) -> key in kept }
            val frame = found?.first
            val filter = found?.let { (frame, kept) -> filterOf(frame.port, kept.getValue(key)) }
            present[key] = PerceptCause(key, false, seconds, frame, if (frame == null) fromOf(percept) else null, filter)
        }
        for (key in present.keys - keys.keys) {
            val was = present.remove(key) ?: continue
            gone[key] = PerceptCause(key, true, seconds, now.map { it.first }.find { it.port == was.frame?.port }, was.from)
        }
    }

    /** Returns the arrival of [percept]; null if the agent does not perceive it now, or if its arrival is not known. */
    fun of(percept: Literal): PerceptCause? = present[keyOf(percept)]

    fun goneOf(percept: Literal): PerceptCause? = gone[keyOf(percept)]

    /** Returns the last departure of a percept for which [matches] is true; null if none is known. */
    fun lastGone(matches: (Literal) -> Boolean): PerceptCause? = gone.values.lastOrNull { matches(literalOf(it.belief)) }

    /** Returns the percepts of [snapshot] that the filter kept, in the form of beliefs, each with its text. */
    private fun keysOf(snapshot: PerceivedSnapshot): Map<String, String> = (snapshot.kept ?: snapshot.texts).mapNotNull { text ->
        believed(text, snapshot.namespace)?.let { keyOf(it) to text }
    }.toMap()

    private fun fromOf(percept: Literal) = if ("${percept.functor}/${percept.arity}" in OWN_BELIEFS) "argo" else "environment"

    private companion object {
        const val MAX_GONE = 1000
    }
}

/** Returns the literal that an agent believes for a board's [text] in [namespace]; null if the text cannot be read. */
internal fun believed(text: String, namespace: String?): Literal? = try {
    PerceptReader.read(text).let { if (namespace == null) it else it.cloneNS(ASSyntax.createAtom(namespace)) as Literal }
} catch (_: PerceptSyntaxException) {
    null
}

internal fun keyOf(literal: Literal): String = literalText(if (literal.hasAnnot()) literal.copy().apply { clearAnnots() } else literal)

/**
 * Numbers the boards' messages that an agent perceives, from 1. If the filter later lets more percepts of a message through, the message
 * comes again with its number.
 */
internal class Frames(private val secondsOf: (Long) -> Double) {
    private val newest = HashMap<String, Pair<Long, Int>>()
    private var count = 0

    /** Returns the frame of [snapshot], the next message. The agent perceived the message in Jason's cycle number [cycle]. */
    fun of(snapshot: PerceivedSnapshot, cycle: Int): Frame {
        val known = newest[snapshot.port]?.takeIf { (receivedNs, _) -> receivedNs == snapshot.receivedNs }
        val number = known?.second ?: ++count
        newest[snapshot.port] = snapshot.receivedNs to number
        return Frame(
            number, snapshot.port, snapshot.namespace, secondsOf(snapshot.receivedNs), cycle, snapshot.texts, snapshot.kept,
        )
    }
}
