package argo.ros.joining

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class PublishedPerceptSpec : FunSpec({
    fun shown(percept: String) = publishedOf(percept)?.run { "$topic $type ${message["data"]}" }

    mapOf(
        "dist(front,38)" to "dist/front std_msgs/Float64 38.0",
        "dist(38.5)" to "dist std_msgs/Float64 38.5",
        "light(back,left,-1)" to "light/back/left std_msgs/Float64 -1.0",
        "hit" to "hit std_msgs/Bool true",
        "door(open)" to "door std_msgs/String \"open\"",
        "door(open,false)" to "door/open std_msgs/Bool false",
        "says(bob,\"Hello, you\")" to "says/bob std_msgs/String \"Hello, you\"",
        "pos(1,2,3)" to "pos std_msgs/Float64MultiArray [1.0,2.0,3.0]",
        "near(a,1,b)" to "near/a std_msgs/String \"1,b\"",
        "seen([a,b])" to "seen std_msgs/String \"[a,b]\"",
        "~open" to "x_open std_msgs/Bool true",
        "'Left wheel'(3)" to "Left_wheel std_msgs/Float64 3.0",
        "dist(X)" to null,
        "dist(front" to null,
        "38" to null,
    ).forEach { (percept, expected) ->
        test("$percept is ${expected ?: "not published"}") { shown(percept) shouldBe expected }
    }

    test("a topic keeps its type, and a board that makes up names gets no more than a thousand") {
        val told = ArrayList<String>()
        val topics = Topics(told::add)
        val publisher = PerceptPublisher("/uno", topics, told::add)
        publisher.publish("temp(1);")
        publisher.publish("temp(\"warm\");")
        told.single() shouldBe "/uno/temp has the type std_msgs/Float64; a percept of the type std_msgs/String is not published"
        repeat(Topics.MAX_TOPICS * 2) { publisher.publish("made$it(1);") }
        topics.types.size shouldBe Topics.MAX_TOPICS
        told.last() shouldBe "there are 1000 topics; percepts that need more are not published"
    }
})
