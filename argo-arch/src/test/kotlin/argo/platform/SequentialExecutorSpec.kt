package argo.platform

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

private const val LIMIT_S = 20L

class SequentialExecutorSpec : FunSpec({
    test("does one thing after the other, in the order given, and its thread ends when nothing is left") {
        val done = ConcurrentLinkedQueue<Int>()
        val threads = ConcurrentLinkedQueue<Thread>()
        val work = SequentialExecutor(Platform.system, "serial")
        repeat(3) { round ->
            val last = CountDownLatch(1)
            (0 until 100).forEach { n ->
                work.execute {
                    threads += Thread.currentThread()
                    done += 100 * round + n
                    if (n == 99) last.countDown()
                }
            }
            check(last.await(LIMIT_S, TimeUnit.SECONDS))
            threads.forEach { it.join(TimeUnit.SECONDS.toMillis(LIMIT_S)) }
            threads.filter { it.isAlive } shouldBe emptyList()
        }
        done.toList() shouldBe (0 until 300).toList()
    }

    test("goes on after what throws") {
        val thrown = ConcurrentLinkedQueue<Throwable>()
        val done = CountDownLatch(2) // the handler may be called after the next thread has begun
        val platform = object : Platform by Platform.system {
            override fun start(name: String, run: () -> Unit) = Thread(run, name).apply {
                setUncaughtExceptionHandler { _, cause -> thrown += cause; done.countDown() }
                start()
            }
        }
        val work = SequentialExecutor(platform, "serial")
        work.execute { error("no such wheel") }
        work.execute { done.countDown() }
        check(done.await(LIMIT_S, TimeUnit.SECONDS))
        thrown.map { it.message } shouldBe listOf("no such wheel")
    }

    test("does what waits with the next work where the machine had no thread for it") {
        var isFull = true
        val platform = object : Platform by Platform.system {
            override fun start(name: String, run: () -> Unit): Thread {
                if (isFull) throw OutOfMemoryError("unable to create native thread")
                return Platform.system.start(name, run)
            }
        }
        val done = ConcurrentLinkedQueue<String>()
        val work = SequentialExecutor(platform, "serial")
        shouldThrow<OutOfMemoryError> { work.execute { done += "first" } }
        isFull = false
        val last = CountDownLatch(1)
        work.execute {
            done += "second"
            last.countDown()
        }
        check(last.await(LIMIT_S, TimeUnit.SECONDS))
        done.toList() shouldBe listOf("first", "second")
    }

    test("what is to be done at once for several is done where the machine has too few threads") {
        val platform = object : Platform by Platform.system {
            override fun start(name: String, run: () -> Unit): Thread {
                if (name != "a") throw OutOfMemoryError("unable to create native thread")
                return Platform.system.start(name, run)
            }
        }
        val done = ConcurrentLinkedQueue<String>()
        platform.forEachAtOnce(listOf("a", "b", "c"), { it }) { done += it }
        done.toSet() shouldBe setOf("a", "b", "c")
    }
})
