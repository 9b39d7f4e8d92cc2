package argo.connecting

import argo.platform.Platform
import java.util.concurrent.TimeUnit
import kotlin.concurrent.withLock

/**
 * The devices that one agent is opening now, by [canonical name][javino.Transports.canonicalName]. One thread at a time opens a device. An
 * opening over a network may take seconds. If the agent asks for a device that a search is opening, the search's opening is interrupted.
 * Safe for use by several threads.
 */
internal class PortOpenings(private val platform: Platform) {
    private val lock = platform.clock.newLock(false)
    private val changed = lock.newCondition()
    private val underWay = HashMap<String, Thread>()

    /** Does [work], which opens [device]. If another thread is opening the device, does nothing. */
    fun ifFree(device: String, work: () -> Unit) {
        if (lock.withLock { underWay.putIfAbsent(device, Thread.currentThread()) } == null) doing(device, work)
    }

    /** Does [work], which opens [device]. If another thread is opening the device, interrupts that thread first. */
    fun <T> atOnce(device: String, work: () -> T): T {
        lock.withLock {
            while (device in underWay) {
                underWay.getValue(device).interrupt()
                platform.clock.await(changed, ENDING_NANOS)
            }
            underWay[device] = Thread.currentThread()
        }
        return doing(device, work)
    }

    fun interrupt() = lock.withLock { underWay.values.forEach(Thread::interrupt) }

    private fun <T> doing(device: String, work: () -> T): T {
        try {
            return work()
        } finally {
            lock.withLock {
                underWay.remove(device)
                changed.signalAll()
            }
            Thread.interrupted() // the interrupt was only for this work
        }
    }

    private companion object {
        val ENDING_NANOS = TimeUnit.MILLISECONDS.toNanos(100)
    }
}
