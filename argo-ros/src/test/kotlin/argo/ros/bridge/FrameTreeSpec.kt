package argo.ros.bridge

import argo.ros.mapping.Frames
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.numericDouble
import io.kotest.property.checkAll
import kotlinx.serialization.json.JsonObject

class FrameTreeSpec : FunSpec({
    val baseInMap = Frames("map", "base")
    val told = ArrayList<String>()
    beforeTest { told.clear() }

    fun tree() = FrameTree(listOf(baseInMap), told::add)

    fun message(parent: String, child: String, x: Double, y: Double, yaw: Double): JsonObject {
        val rotation = """{"x": 0, "y": 0, "z": ${Math.sin(yaw / 2)}, "w": ${Math.cos(yaw / 2)}}"""
        val transform = """{"translation": {"x": $x, "y": $y, "z": 0}, "rotation": $rotation}"""
        val one = """{"header": {"frame_id": "$parent"}, "child_frame_id": "$child", "transform": $transform}"""
        return checkNotNull(operationIn("""{"transforms": [$one]}"""))
    }

    fun FrameTree.add(parent: String, child: String, x: Double, y: Double, yaw: Double, atNanos: Long = 0, isStatic: Boolean = false) =
        add(message(parent, child, x, y, yaw), isStatic, atNanos) { atNanos }

    fun FrameTree.xyYaw(of: Frames, nowNanos: Long = 0) =
        pose(of, nowNanos)?.json?.let { pose -> listOf("x", "y", "yaw").map { pose.text(it)!!.toDouble() } }

    test("a pose goes along all frames between the two, in both directions, and is as old as the oldest that moves") {
        val tree = tree()
        tree.add("/map", "odom", 1.0, 0.0, Math.PI / 2, atNanos = 10)
        tree.add("odom", "base", 2.0, 0.0, 0.0, atNanos = 30)
        tree.add("base", "laser", 0.0, 1.0, 0.0, atNanos = 5, isStatic = true)
        for ((child, place) in listOf("base" to listOf(1.0, 2.0, Math.PI / 2), "laser" to listOf(0.0, 2.0, Math.PI / 2))) {
            tree.xyYaw(Frames("map", child))!!.zip(place).forEach { (found, expected) -> found shouldBe (expected plusOrMinus 1e-9) }
        }
        tree.pose(Frames("map", "laser"), 40)?.trueNanos shouldBe 10
        tree.pose(Frames("base", "laser"), 40)?.trueNanos shouldBe 40
    }
    test("the pose of one frame in another is undone by that of the other in the first") {
        checkAll(20, Arb.list(Arb.numericDouble(-3.0, 3.0), 6..6)) { (x, y, yaw, p, q, turn) ->
            val tree = tree()
            tree.add("map", "odom", x, y, yaw)
            tree.add("odom", "base", p, q, turn)
            val (there, back) = tree.pose(baseInMap, 0)!!.json to tree.pose(Frames("base", "map"), 0)!!.json
            fun transform(pose: JsonObject) = Transform.of(JsonObject(mapOf("translation" to pose, "rotation" to pose["rotation"]!!)))!!
            val none = (transform(there) * transform(back)).json
            for (name in listOf("x", "y", "z", "yaw")) none.text(name)!!.toDouble() shouldBe (0.0 plusOrMinus 1e-9)
        }
    }
    test("frames that are not connected have no pose, which is told after five seconds, with the frames that there are") {
        val tree = tree()
        tree.add("map", "odom", 0.0, 0.0, 0.0)
        tree.add("base_link", "laser", 0.0, 0.0, 0.0)
        tree.xyYaw(baseInMap) shouldBe null
        told.shouldBeEmpty()
        tree.xyYaw(baseInMap, 2 * SilentTopics.LIMIT_NANOS) shouldBe null
        told shouldBe listOf("frames map and base are not connected; there are base_link, laser, map, odom")
    }
    test("of more frames than a robot has the others are left out, which is told") {
        val tree = tree()
        for (n in 1..1_001) tree.add("map", "frame$n", 0.0, 0.0, 0.0)
        told shouldBe listOf("there are more than 1000 frames; the others, as frame1001, are left out")
    }
    test("a circle of frames, and transforms that are none, do no harm") {
        val tree = tree()
        tree.add("base", "odom", 0.0, 0.0, 0.0)
        tree.add("odom", "base", 0.0, 0.0, 0.0)
        val broken = """{"transforms": [{}, 7, {"header": {"frame_id": "map"}, "child_frame_id": "base", "transform": {"rotation": {}}}]}"""
        tree.add(checkNotNull(operationIn(broken)), false, 0) { 0 }
        tree.xyYaw(baseInMap) shouldBe null
    }
})

private operator fun <T> List<T>.component6(): T = get(5)
