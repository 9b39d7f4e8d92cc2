package argo.observing

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.CountDownLatch

class FarewellSpec : FunSpec({
    val told = CopyOnWriteArrayList<String>()
    beforeEach { told.clear() }

    test("a farewell that takes too long is told") {
        val hangs = CountDownLatch(1)
        Farewell(1, "the end is missing", told::add) { hangs.await() }.use { it.bid() }
        told shouldContainExactly listOf("the end is missing")
        hangs.countDown()
    }

    test("a farewell that has been said is not told") {
        Farewell(20_000, "the end is missing", told::add) {}.use { it.bid() }
        told.shouldBeEmpty()
    }
})
