package argo

import argo.jason.eventually
import io.kotest.core.spec.style.FunSpec
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
})
