package argo.ros.bridge

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.util.concurrent.CompletableFuture

class OutboxSpec : FunSpec({
    val written = ArrayList<String>()
    val underWay = ArrayDeque<CompletableFuture<Unit>>()
    val outbox = Outbox { text ->
        written += text
        CompletableFuture<Unit>().also(underWay::addLast)
    }
    fun add(message: Outgoing) = message.also {
        outbox.add(it)
        outbox.flush()
    }
    fun reasonOf(message: Outgoing) = message.left.handle { _, trouble -> trouble?.javaClass?.simpleName }.getNow("waits")

    test("messages go out one by one, urgent ones first, and a later one takes the place of those it replaces") {
        val first = add(Outgoing("first", functor = "speed"))
        val slow = add(Outgoing("slow", functor = "speed"))
        val other = add(Outgoing("other"))
        val fast = add(Outgoing("fast", functor = "speed", replaces = true))
        val stop = add(Outgoing("stop", isUrgent = true))
        val gone = add(Outgoing("gone")).also { it.withdraw() shouldBe true }
        while (underWay.isNotEmpty()) underWay.removeFirst().complete(Unit)
        written shouldBe listOf("first", "stop", "fast", "other")
        listOf(first, slow, other, fast, stop, gone).map(::reasonOf) shouldBe listOf(null, "Replaced", null, null, null, "waits")
        first.withdraw() shouldBe false
    }
    test("what waits when the connection is closed never goes out") {
        written.clear()
        val under = add(Outgoing("under way"))
        val waiting = add(Outgoing("waiting"))
        outbox.close()
        underWay.removeFirst().complete(Unit)
        val late = add(Outgoing("late"))
        written shouldBe listOf("under way")
        listOf(under, waiting, late).map(::reasonOf) shouldBe listOf(null, "NeverSent", "NeverSent")
    }
})
