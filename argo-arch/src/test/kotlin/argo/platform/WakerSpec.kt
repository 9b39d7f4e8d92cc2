package argo.platform

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import jason.architecture.AgArch
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

private class Sleeper : AgArch() {
    @Volatile
    var wakes = 0

    override fun wakeUpSense() {
        wakes++
    }
}

/** An agent that sleeps and is woken, in virtual time. */
private class Waking {
    val time = TestTime()
    val agent = Sleeper()
    val waker = Waker(agent, time)
}

class WakerSpec : FunSpec({
    fun waking(name: String, body: Waking.() -> Unit) = test(name) { Waking().body() }

    waking("an agent that may fall asleep just when it is to perceive is woken again and again until it does") {
        waker.perceives()
        waker.wakeIn(100)
        waker.maySleep() shouldBe true // but does not sleep yet
        repeat(4) { time.step() } // after 100 ms, and 1, 2 and 4 ms later
        time.nowMs() shouldBe 107
        agent.wakes shouldBe 4
        waker.perceives()
        while (!time.isIdle()) time.step()
        agent.wakes shouldBe 4
    }

    waking("an agent that is woken while a cycle runs does not fall asleep behind it, and is woken once") {
        waker.perceives()
        waker.maySleep() shouldBe true
        waker.perceives()
        waker.wake { false }
        time.isIdle() shouldBe true
        agent.wakes shouldBe 1
        waker.maySleep() shouldBe false
        waker.perceives()
        waker.maySleep() shouldBe true
    }

    waking("an agent that wakes itself in its cycle does not fall asleep behind it, and nobody is woken") {
        waker.perceives()
        waker.maySleep() shouldBe true
        waker.cycleStarts()
        waker.perceives()
        waker.wake { false }
        waker.maySleep() shouldBe false
        waker.cycleEnds()
        time.isIdle() shouldBe true
        agent.wakes shouldBe 0
        waker.wake { false }
        agent.wakes shouldBe 1
    }

    waking("an agent that sleeps is woken once") {
        val slept = CountDownLatch(1)
        val thread = thread {
            waker.perceives()
            waker.maySleep()
            slept.await(60, TimeUnit.SECONDS)
        }
        while (thread.state != Thread.State.TIMED_WAITING) Thread.onSpinWait()
        waker.wake { false }
        time.isIdle() shouldBe true
        agent.wakes shouldBe 1
        slept.countDown()
    }

    waking("an agent that another thread lets sleep than the one that perceives is woken again and again") {
        waker.perceives()
        thread { waker.maySleep() }.join()
        waker.maySleep() shouldBe true
        waker.perceives()
        waker.wake { false }
        time.isIdle() shouldBe false
        waker.maySleep() shouldBe true
    }

    waking("an agent that falls asleep unasked, as an atomic plan waits, is woken again and again") {
        waker.perceives()
        waker.maySleep() shouldBe true
        waker.perceives()
        waker.wake { false }
        time.isIdle() shouldBe true
        waker.sleepsUnasked()
        repeat(2) { time.step() } // 1 and 2 ms later
        agent.wakes shouldBe 4
        waker.perceives()
        while (!time.isIdle()) time.step()
        agent.wakes shouldBe 4
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
