package argo.testkit

import java.util.Date
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.Condition
import java.util.concurrent.locks.Lock

/** A reentrant, fair lock for the threads of [time]. Only one thread of [time] runs at a time. */
internal class VirtualLock(private val time: VirtualTime) : Lock {
    private var owner: Any? = null
    private var holds = 0
    private val asking = ArrayDeque<Any>()

    private fun me(): Any = time.running ?: time // [time] stands for the driver, for which running is null

    private fun isFree() = holds == 0 || owner === me()

    override fun lock() {
        take(null, false)
    }

    override fun lockInterruptibly() {
        take(null, true)
    }

    override fun tryLock(): Boolean = isFree().also { if (it) enter(1) }

    override fun tryLock(time: Long, unit: TimeUnit): Boolean = take(this.time.nanos() + unit.toNanos(time), true)

    private fun take(deadlineNanos: Long?, interruptible: Boolean): Boolean {
        if (holds > 0 && owner === me() || holds == 0 && asking.isEmpty()) return tryLock()
        return awaitTurn(deadlineNanos, interruptible).also { if (it) enter(1) }
    }

    private fun awaitTurn(deadlineNanos: Long?, interruptible: Boolean): Boolean {
        val turn = Any().also(asking::addLast)
        val comes = { holds == 0 && asking.first() === turn }
        try {
            time.block(deadlineNanos, interruptible, comes)
            return comes()
        } finally {
            asking -= turn
        }
    }

    private fun enter(times: Int) {
        owner = me()
        holds += times
    }

    override fun unlock() {
        requireMine()
        holds--
    }

    private fun requireMine() {
        if (holds == 0 || owner !== me()) throw IllegalMonitorStateException("the lock belongs to another thread")
    }

    override fun newCondition(): Condition = VirtualCondition()

    private inner class VirtualCondition : Condition {
        private val waiting = ArrayDeque<Waiter>()

        override fun signal() {
            requireMine()
            waiting.removeFirstOrNull()?.signalled = true
        }

        override fun signalAll() {
            while (waiting.isNotEmpty()) signal()
            requireMine()
        }

        override fun awaitNanos(nanosTimeout: Long): Long {
            requireMine()
            val deadline = time.nanos() + nanosTimeout
            wait(if (deadline < 0) null else deadline, true) // an overflow means no limit
            return deadline - time.nanos()
        }

        override fun await() = wait(null, true)

        override fun awaitUninterruptibly() = wait(null, false)

        override fun await(time: Long, unit: TimeUnit): Boolean = awaitNanos(unit.toNanos(time)) > 0

        override fun awaitUntil(deadline: Date): Boolean = throw UnsupportedOperationException("this time has no dates")

        private fun wait(deadlineNanos: Long?, interruptible: Boolean) {
            requireMine()
            val held = holds
            val waiter = Waiter().also(waiting::addLast)
            holds = 0
            try {
                time.block(deadlineNanos, interruptible) { waiter.signalled }
            } finally {
                waiting -= waiter
                take(null, false) // a free lock costs no switch of threads
                holds = held
            }
        }
    }

    private class Waiter {
        var signalled = false
    }
}
