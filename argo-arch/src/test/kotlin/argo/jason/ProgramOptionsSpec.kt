package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class ProgramOptionsSpec : FunSpec({
    test("a property of the program is an option of each agent that does not have it itself; an unknown one is told once") {
        val properties = mapOf("argo_sensing" to "always", "argo_percepts" to "few", "argo_fly" to "high")
        properties.forEach(System::setProperty)
        try {
            LocalMas().use { mas ->
                mas.agent("ann", "!start. +!start <- +ready.")
                mas.agent("bob", "!start. +!start <- +ready.", mapOf("argo_sensing" to "never"))
                listOf("ann", "bob").forEach { mas.awaitBelief(it, "ready") }
                val told = mas.log.lines().filter { "argo_" in it }
                told.count { "argo_fly is not an option" in it } shouldBe 1
                told.single { "argo_sensing=always" in it } shouldContain "Arch.ann"
                told.single { "argo_sensing=never" in it } shouldContain "Arch.bob"
                told.count { "argo_percepts=few" in it } shouldBe 2
            }
        } finally {
            properties.keys.forEach(System::clearProperty)
        }
    }
})
