package argo.recording.agent

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

/** A plan's file has one name in a recording, whatever form of the path Jason got. */
class FileNameSpec : FunSpec({
    for (path in listOf("robot.asl", "file:robot.asl", "file:/home/robots/robot.asl", "src/agt/robot.asl", """C:\robots\robot.asl""")) {
        test(path) { fileName(path) shouldBe "robot.asl" }
    }
})
