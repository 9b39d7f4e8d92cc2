package argo.view

import java.util.concurrent.TimeUnit

/** Waits until [condition] holds; fails with the text of [found] after twenty seconds, which no machine needs. */
internal fun eventually(found: () -> Any?, condition: () -> Boolean) {
    val end = System.nanoTime() + TimeUnit.SECONDS.toNanos(20)
    while (!condition()) {
        check(System.nanoTime() < end) { "not so within 20 s: ${found()}" }
        Thread.sleep(5)
    }
}
