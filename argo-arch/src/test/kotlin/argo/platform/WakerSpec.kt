package argo.platform

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import jason.architecture.AgArch

class WakerSpec : FunSpec({
    test("an agent that is to perceive later is woken again and again until it does, since it may fall asleep just then") {
        val time = TestTime()
        var wakes = 0
        val agent = object : AgArch() {
            override fun wakeUpSense() {
                wakes++
            }
        }
        val waker = Waker(agent, time)
        waker.perceives()
        waker.wakeIn(100)
        repeat(4) { time.step() } // after 100 ms, and 1, 2 and 4 ms later
        time.nowMs() shouldBe 107
        wakes shouldBe 4
        waker.perceives()
        while (!time.isIdle()) time.step()
        wakes shouldBe 4
    }

    test("an agent that never perceives is not woken for ever") {
        val time = TestTime()
        Waker(AgArch(), time).wakeIn(1)
        repeat(12) { time.step() } // the last wait is one of 1024 ms
        time.isIdle() shouldBe true
    }

    test("an agent is woken by each call that one infrastructure or another knows") {
        val calls = HashSet<String>()
        val arch = object : AgArch() {
            override fun isRunning() = true
            override fun wake() { calls += "wake" }
            override fun wakeUpSense() { calls += "wakeUpSense" }
            override fun wakeUpDeliberate() { calls += "wakeUpDeliberate" }
        }
        Waker(arch).wake { true }
        calls shouldContainAll setOf("wake", "wakeUpSense", "wakeUpDeliberate")
    }
})
