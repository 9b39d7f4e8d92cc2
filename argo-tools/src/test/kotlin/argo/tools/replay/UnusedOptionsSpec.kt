package argo.tools.replay

import argo.testkit.agentOf
import argo.tools.argo
import io.kotest.core.annotation.Isolate
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlin.io.path.exists
import kotlin.time.Duration.Companion.milliseconds

@Isolate // the specs of this program share its properties
class UnusedOptionsSpec : FunSpec({
    test("options among the program's properties do not reach the agents of a recording, which is told") {
        val (drive, again) = tempdir().toPath().let { it.resolve("drive.mcap") to it.resolve("again.mcap") }
        agentOf("!start. +!start <- +ready.") { options("argo_record" to "$drive") }.use { it.after(300.milliseconds) }
        System.setProperty("argo_record", "$again")
        try {
            argo("replay", "$drive").run {
                err shouldBe "-Dargo_record has no effect: the agents have recorded options\n"
                out shouldContain "identical:"
                status shouldBe 0
            }
            argo("why", "$drive", "stop").err shouldContain "-Dargo_record has no effect"
            again.exists() shouldBe false
        } finally {
            System.clearProperty("argo_record")
        }
    }
})
