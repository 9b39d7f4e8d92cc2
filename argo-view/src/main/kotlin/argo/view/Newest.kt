package argo.view

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** Holds the newest of what one thread says for any number of others, who miss what they are too slow for. */
internal class Newest<T : Any> {
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private var said: Said<T>? = null

    /** Replaces what was said before. */
    fun say(value: T) = lock.withLock {
        said = Said(value, (said?.number ?: 0) + 1)
        changed.signalAll()
    }

    /** How many things have been said. */
    val count: Long get() = lock.withLock { said?.number ?: 0 }

    /** Waits for something newer than number [after], at most [limitNanos] ns; null: there is nothing. */
    fun await(after: Long, limitNanos: Long): Said<T>? = lock.withLock {
        var left = limitNanos
        while ((said?.number ?: 0) <= after && left > 0) left = changed.awaitNanos(left)
        said?.takeIf { it.number > after }
    }

    /** The [number]th thing that was said. */
    class Said<T>(val value: T, val number: Long)
}
