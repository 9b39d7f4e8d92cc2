package argo.platform

import java.util.concurrent.TimeUnit
import kotlin.concurrent.withLock

/**
 * Does [work] for each of [items] on a separate thread called [name]. If the machine has no thread left, uses the calling thread. Returns
 * when all work has ended. An exception of [work] ends only its thread.
 */
internal fun <T> Platform.forEachAtOnce(items: List<T>, name: (T) -> String, work: (T) -> Unit) {
    if (items.size < 2) return items.forEach(work)
    val lock = clock.newLock(false)
    val ended = lock.newCondition()
    var underWay = items.size
    for (item in items) {
        val run = {
            try {
                work(item)
            } finally {
                lock.withLock {
                    underWay--
                    ended.signalAll()
                }
            }
        }
        try {
            start(name(item), run)
        } catch (_: OutOfMemoryError) { // Java throws this error if the machine has no thread left
            run()
        }
    }
    lock.withLock { while (underWay > 0) clock.await(ended, LOOK_NANOS) }
}

private val LOOK_NANOS = TimeUnit.SECONDS.toNanos(1)
