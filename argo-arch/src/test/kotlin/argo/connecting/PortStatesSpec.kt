package argo.connecting

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax

class PortStatesSpec : FunSpec({
    val port = ASSyntax.createAtom("ttyACM0")

    test("a state is told once, until it changes") {
        val told = ArrayList<String>()
        val states = PortStates { _, status, reason -> told += "${status.word} $reason" }
        states.set(port, PortStatus.ON)
        states.set(port, PortStatus.ON)
        states.set(port, PortStatus.TIMEOUT, "silence")
        told shouldBe listOf("on null", "timeout silence")
        states.hasNews() shouldBe true
        states.beliefs().map { "$it" } shouldBe listOf("port(ttyACM0,timeout)")
        states.hasNews() shouldBe false
    }

    test("what is said late of a port that has been given up is not believed") {
        val states = PortStates { _, status, _ -> error("told $status") }
        states.clear()
        states.set(port, PortStatus.TIMEOUT, "silence") { false }
        states.beliefs().shouldBeEmpty()
    }
})
