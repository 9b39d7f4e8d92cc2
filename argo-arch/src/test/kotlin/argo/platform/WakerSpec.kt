package argo.platform

import argo.jason.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import jason.architecture.AgArch
import java.util.concurrent.atomic.AtomicInteger

class WakerSpec : FunSpec({
    test("an agent that is to perceive later is woken again and again until it does, since it may fall asleep just then") {
        val wakes = AtomicInteger()
        val agent = object : AgArch() {
            override fun wakeUpSense() {
                wakes.incrementAndGet()
            }
        }
        val waker = Waker(agent)
        waker.perceives()
        waker.wakeIn(1)
        eventually({ "${wakes.get()} wake-ups" }) { wakes.get() >= 4 }
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
