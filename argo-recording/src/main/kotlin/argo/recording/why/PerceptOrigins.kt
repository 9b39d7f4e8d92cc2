package argo.recording.why

import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.recording.PerceivedSnapshot
import argo.recording.agent.literalOf
import argo.recording.agent.literalText
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal

/** Which frame each percept of an agent came by, and went by. */
internal class PerceptOrigins(private val secondsOf: (Long) -> Double, private val filterOf: (port: String, text: String) -> String?) {
    private val present = HashMap<String, PerceptCause>()
    private val gone = object : LinkedHashMap<String, PerceptCause>() {
        override fun removeEldestEntry(eldest: Map.Entry<String, PerceptCause>) = size > MAX_GONE
    }
    private val newest = LinkedHashMap<String, Frame>()
    private val frames = Frames(secondsOf)
    private val earlier = HashSet<String>()

    /** The newest frame of each board that has been perceived. */
    val newestFrames: Collection<Frame> get() = newest.values

    /** These [percepts] are perceived when the replay begins: the frame is not known that they came by. */
    fun beginWith(percepts: List<Literal>) {
        percepts.mapTo(earlier, ::keyOf)
    }

    /** The agent perceives [percepts] in the cycle of this [number] at [ns], of [snapshots] and of what it perceived before. */
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

    /** How [percept] came that is perceived now; null: it is not perceived. */
    fun of(percept: Literal): PerceptCause? = present[keyOf(percept)]

    /** How [percept] went; null: it is not known. */
    fun goneOf(percept: Literal): PerceptCause? = gone[keyOf(percept)]

    /** How the percept went last that [matches]; null: none has. */
    fun lastGone(matches: (Literal) -> Boolean): PerceptCause? = gone.values.lastOrNull { matches(literalOf(it.belief)) }

    /** The percepts in [snapshot] that were kept, as they are believed, each with its text. */
    private fun keysOf(snapshot: PerceivedSnapshot): Map<String, String> = (snapshot.kept ?: snapshot.texts).mapNotNull { text ->
        believed(text, snapshot.namespace)?.let { keyOf(it) to text }
    }.toMap()

    private fun fromOf(percept: Literal) = if ("${percept.functor}/${percept.arity}" in OF_ARGO) "argo" else "environment"

    private companion object {
        const val MAX_GONE = 1000
        val OF_ARGO = setOf("port/2", "stale/1", "reflex/2")
    }
}

/** The percept that a board's [text] is believed as in [namespace]; null: it cannot be read. */
internal fun believed(text: String, namespace: String?): Literal? = try {
    PerceptReader.read(text).let { if (namespace == null) it else it.cloneNS(ASSyntax.createAtom(namespace)) as Literal }
} catch (_: PerceptSyntaxException) {
    null
}

/** What [literal] is without its annotations. */
internal fun keyOf(literal: Literal): String = literalText(if (literal.hasAnnot()) literal.copy().apply { clearAnnots() } else literal)
