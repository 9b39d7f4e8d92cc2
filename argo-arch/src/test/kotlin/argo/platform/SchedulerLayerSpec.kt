package argo.platform

import argo.platform.SchedulerLayer.Place
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import jason.asSemantics.Agent
import java.util.concurrent.Callable
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.ScheduledFuture
import java.util.concurrent.TimeUnit

class SchedulerLayerSpec : FunSpec({
    test("a layer that sees an agent's timers stands above the one that says when they end, whichever came first") {
        SchedulerLayer.install(Watch::class.java, Place.AGENT, ::Watch)
        SchedulerLayer.install(Time::class.java, Place.TIME, ::Time)
        SchedulerLayer.install(Watch::class.java, Place.AGENT, ::Watch)
        val timer = Timer()
        Agent.getScheduler().schedule(timer, 1, TimeUnit.MILLISECONDS).get()
        timer.seenBy shouldContainExactly listOf("watch", "time", "machine")
    }
})

private class Timer : Callable<Unit> {
    val seenBy = mutableListOf<String>()

    override fun call() {
        seenBy += "machine"
    }
}

private open class Named(private val name: String, below: ScheduledExecutorService) : SchedulerLayer(below) {
    override fun <V : Any?> later(work: Callable<V>, delay: Long, unit: TimeUnit): ScheduledFuture<V> {
        if (work is Timer) work.seenBy += name
        return below.schedule(work, delay, unit)
    }
}

private class Watch(below: ScheduledExecutorService) : Named("watch", below)

private class Time(below: ScheduledExecutorService) : Named("time", below)
