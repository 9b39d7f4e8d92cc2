package argo.ros.bridge

import argo.ros.mapping.Frames
import argo.ros.mapping.headingOf
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * The frames of a robot. Each has its newest transform into its parent frame. Not safe for use by several threads at once.
 *
 * @param wanted the frames whose poses rules use
 * @param warn takes a sentence if two wanted frames are still unconnected after [LIMIT_NANOS]
 */
internal class FrameTree(private val wanted: List<Frames>, private val warn: (String) -> Unit) {
    private class Frame(val parent: String, val transform: Transform, val trueNanos: Long, val isStatic: Boolean)

    /** The pose of one frame in another, as a message. [trueNanos] is the platform time at which the pose was true. */
    class Pose(val json: JsonObject, val trueNanos: Long)

    private val frames = HashMap<String, Frame>()
    private var begunNanos: Long? = null // the time of the first message
    private val told = HashSet<Frames>()

    /**
     * Stores the transforms in [message], which arrived at [nowNanos].
     *
     * @param trueAt returns the platform time for a time stamp of the robot
     */
    fun add(message: JsonObject, isStatic: Boolean, nowNanos: Long, trueAt: (stampNanos: Long?) -> Long) {
        if (wanted.isEmpty()) return
        begunNanos = begunNanos ?: nowNanos
        for (one in (message["transforms"] as? JsonArray).orEmpty().filterIsInstance<JsonObject>()) {
            val header = one.part("header")
            val parent = header?.text("frame_id") ?: continue
            val child = one.text("child_frame_id") ?: continue
            val transform = one.part("transform")?.let(Transform::of) ?: continue
            if (frames.size >= MAX_FRAMES && nameOf(child) !in frames) {
                warn("there are more than $MAX_FRAMES frames; the others, as ${nameOf(child).take(SHOWN)}, are left out")
                return
            }
            val trueNanos = if (isStatic) nowNanos else trueAt(header.part("stamp")?.rosNanos())
            frames[nameOf(child)] = Frame(nameOf(parent), transform, trueNanos, isStatic)
        }
    }

    /** Returns the pose of the child frame in the parent frame of [of], or null if the frames are not connected. */
    fun pose(of: Frames, nowNanos: Long): Pose? {
        val (up, down) = wayFrom(of.child) to wayFrom(of.parent)
        if (topOf(of.child, up) != topOf(of.parent, down)) {
            if (nowNanos - (begunNanos ?: nowNanos) > LIMIT_NANOS) tellApart(of)
            return null
        }
        val transform = inTop(down).inverse() * inTop(up)
        val between = up - down.toSet() + (down - up.toSet())
        val trueNanos = between.filter { !it.isStatic }.minOfOrNull { it.trueNanos - nowNanos } ?: 0
        return Pose(transform.json, nowNanos + trueNanos)
    }

    private fun tellApart(of: Frames) {
        if (told.add(of)) warn("frames ${of.parent} and ${of.child} are not connected; ${known()}")
    }

    /** Warns at once of wanted frames that are not connected. */
    fun explain() = wanted.filter { pose(it, begunNanos ?: 0) == null }.forEach(::tellApart)

    /** Returns the frames from [name] up to the root, without the root. Stops at a frame that it has already visited. */
    private fun wayFrom(name: String): List<Frame> {
        val seen = HashSet<String>()
        return generateSequence(frames[name]) { frame -> frames[frame.parent]?.takeIf { seen.add(frame.parent) } }.toList()
    }

    private fun topOf(name: String, way: List<Frame>) = way.lastOrNull()?.parent ?: name

    private fun inTop(way: List<Frame>) = way.fold(Transform.NONE) { inner, frame -> frame.transform * inner }

    private fun known(): String {
        val names = (frames.keys + frames.values.map { it.parent }).sorted()
        return if (names.isEmpty()) "there are none" else "there are ${names.joinToString(", ").take(SHOWN)}"
    }

    private fun nameOf(frame: String) = frame.removePrefix("/")

    private companion object {
        val LIMIT_NANOS = SilentTopics.LIMIT_NANOS
        const val SHOWN = 500
        const val MAX_FRAMES = 1_000
    }
}

/** A rotation by the unit quaternion [q] (x, y, z, w), and then a move by [move]. */
internal class Transform private constructor(private val move: List<Double>, private val q: List<Double>) {
    operator fun times(inner: Transform) = Transform(sum(move, rotated(inner.move)), product(q, inner.q))

    fun inverse(): Transform {
        val back = Transform(NONE.move, opposite())
        return Transform(back.rotated(move.map { -it }), back.q)
    }

    private fun opposite() = q.mapIndexed { index, part -> if (index < W) -part else part }

    private fun rotated(v: List<Double>) = product(product(q, v + 0.0), opposite()).take(W)

    /** The transform as a message with x, y, z, the yaw in rad, and the rotation as a quaternion. */
    val json: JsonObject
        get() {
            val rotation = JsonObject(AXES.zip(q.map { JsonPrimitive(it) }).toMap())
            val (x, y, z, w) = q
            val yaw = headingOf(x, y, z, w)
            val place = AXES.zip(move.map { JsonPrimitive(it) })
            return JsonObject(place.toMap() + mapOf("yaw" to JsonPrimitive(yaw), "rotation" to rotation))
        }

    companion object {
        private val AXES = listOf("x", "y", "z", "w")
        private const val W = 3
        val NONE = Transform(listOf(0.0, 0.0, 0.0), listOf(0.0, 0.0, 0.0, 1.0))

        /** Reads a `geometry_msgs/Transform`, or returns null if [message] is no transform. */
        fun of(message: JsonObject): Transform? {
            val move = numbers(message.part("translation"), AXES.take(W)) ?: return null
            val rotation = numbers(message.part("rotation"), AXES) ?: return null
            val length = Math.sqrt(rotation.sumOf { it * it })
            return if (length > 0) Transform(move, rotation.map { it / length }) else null
        }

        private fun numbers(message: JsonObject?, names: List<String>): List<Double>? =
            names.map { message?.text(it)?.toDoubleOrNull()?.takeIf(Double::isFinite) ?: return null }

        private fun sum(a: List<Double>, b: List<Double>) = a.zip(b) { one, other -> one + other }

        private fun product(a: List<Double>, b: List<Double>): List<Double> {
            val (x, y, z, w) = a
            val (p, q, r, s) = b
            return listOf(
                w * p + x * s + y * r - z * q, w * q - x * r + y * s + z * p, w * r + x * q - y * p + z * s, w * s - x * p - y * q - z * r,
            )
        }
    }
}
