package argo.ros.serving

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import java.util.PriorityQueue
import java.util.concurrent.TimeUnit.MILLISECONDS
import java.util.concurrent.TimeUnit.NANOSECONDS
import java.util.concurrent.TimeUnit.SECONDS

/** A client in virtual time that takes [workMs] for each message, and answers pings in its order. */
private class SlowClient(private val workMs: Long) {
    private class Event(val nanos: Long, val number: Int, val action: () -> Unit)

    private val events = PriorityQueue<Event>(compareBy({ it.nanos }, { it.number }))
    private var number = 0
    var now = 0L
    private var busyUntil = 0L
    private var random = 0L
    var answersPings = true

    /** The messages that were handled, each with its time in ms. */
    val handled = ArrayList<Pair<String, Long>>()
    var ended: String? = null
    val pings = ArrayList<Long>()

    val subscriber: Subscriber = Subscriber(
        object : ClientSocket {
            override fun send(text: String) {
                busyUntil = maxOf(busyUntil, now) + MILLISECONDS.toNanos(workMs)
                at(busyUntil) { handled += text to MILLISECONDS.convert(now, NANOSECONDS) }
            }

            override fun ping(number: Long) {
                pings += number
                if (answersPings) at(maxOf(busyUntil, now)) { subscriberOf().answered(number) }
            }

            override fun end(reason: String) {
                ended = reason
            }
        },
        { now }, { ++random }, { delay, action -> at(now + delay, action) },
    )

    private fun subscriberOf() = subscriber

    fun at(nanos: Long, action: () -> Unit) {
        events += Event(nanos, number++, action)
    }

    fun run(untilMs: Long) {
        val end = MILLISECONDS.toNanos(untilMs)
        while (events.isNotEmpty() && events.peek().nanos <= end) events.poll().run {
            now = maxOf(now, nanos)
            action()
        }
        now = end
    }
}

class SubscriberSpec : FunSpec({
    /** Publishes the time in ms on `/t`, [hz] times a second for [seconds]. */
    fun SlowClient.publishes(hz: Int, seconds: Int, topic: String = "/t") = repeat(hz * seconds) { count ->
        val nanos = SECONDS.toNanos(1) / hz * count
        at(nanos) { subscriber.published(topic, "${MILLISECONDS.convert(nanos, NANOSECONDS)}", false) }
    }

    listOf(50, 200, 1_000).forEach { hz ->
        test("a client that takes 100 ms a message handles none that is older than 0.25 s, at $hz Hz after a minute") {
            val client = SlowClient(100)
            client.subscriber.subscribe("/t", "a", 0, 0, null)
            client.publishes(hz, 60)
            client.run(60_000)
            client.handled.maxOf { (sent, handled) -> handled - sent.toLong() } shouldBeLessThan 250L
            client.handled.last().second shouldBe 60_000L - 60_000L % 100
        }
    }
    test("a client that is fast gets all that is published") {
        val client = SlowClient(0)
        client.subscriber.subscribe("/t", "a", 0, 0, null)
        client.publishes(50, 10)
        client.run(10_000)
        client.handled.size shouldBe 500
    }
    test("an interval is kept, and the last message comes though none follows") {
        val client = SlowClient(0)
        client.subscriber.subscribe("/t", "a", 110, 1, null)
        client.publishes(50, 1)
        client.run(5_000)
        client.handled.map { it.second } shouldBe (0L..990L step 110).toList()
        client.handled.last().first shouldBe "980"
    }
    test("a queue keeps as many as it is long") {
        val client = SlowClient(0)
        client.subscriber.subscribe("/t", "a", 1_000, 3, null)
        client.publishes(50, 1)
        client.run(10_000)
        client.handled.map { it.first } shouldBe listOf("0", "940", "960", "980")
    }
    test("of several subscriptions the shortest interval counts, and the topic goes on until the last is ended") {
        val client = SlowClient(0)
        client.subscriber.subscribe("/t", "a", 1_000, 1, null)
        client.subscriber.subscribe("/t", "b", 0, 1, null)
        client.subscriber.published("/t", "1", false)
        client.subscriber.unsubscribe("/t", "b")
        client.subscriber.published("/t", "2", false)
        client.run(500)
        client.handled.map { it.first } shouldBe listOf("1")
        client.run(1_500)
        client.handled.map { it.first } shouldBe listOf("1", "2")
        client.subscriber.unsubscribe("/t", null)
        client.subscriber.published("/t", "3", false)
        client.run(5_000)
        client.handled.size shouldBe 2
    }
    test("results are kept, and a new subscriber gets the newest message") {
        val client = SlowClient(100)
        client.subscriber.subscribe("/r", "a", 0, 0, "old")
        repeat(5) { client.subscriber.published("/r", "$it", true) }
        client.run(1_000)
        client.handled.map { it.first } shouldBe listOf("old", "0", "1", "2", "3", "4")
    }
    test("a client that reads nothing is sent one round, and left after twenty seconds") {
        val client = SlowClient(0).apply { answersPings = false }
        client.subscriber.subscribe("/t", "a", 0, 0, null)
        client.publishes(1_000, 19)
        client.run(19_000)
        client.handled.size shouldBe 1
        client.subscriber.check()
        client.ended shouldBe null
        client.run(21_000)
        client.subscriber.check()
        client.ended shouldBe "it does not answer a ping"
    }
    test("a client that does not read its answers is left before they are a burden") {
        val client = SlowClient(0).apply { answersPings = false }
        val answer = "x".repeat(10_000)
        var sent = 0
        while (client.ended == null && sent < 10_000) client.subscriber.send(answer).also { sent++ }
        client.ended shouldBe "it does not read what it is sent"
        sent * answer.length.toLong() shouldBeLessThan Subscriber.MAX_UNREAD + 20_000
    }
    test("one that answers pings which it was not sent gains nothing") {
        val client = SlowClient(0).apply { answersPings = false }
        client.subscriber.subscribe("/t", "a", 0, 0, null)
        client.publishes(50, 2)
        repeat(100) { client.at(MILLISECONDS.toNanos(it * 20L)) { client.subscriber.answered(-5) } }
        client.run(2_000)
        client.pings.size shouldBe 1
    }
    test("there are a thousand subscriptions and no more") {
        val client = SlowClient(0)
        (1..2_000).count { client.subscriber.subscribe("/t$it", "", 0, 0, null) } shouldBe Subscriber.MAX_SUBSCRIPTIONS
        client.subscriber.subscribe("/t1", "", 50, 0, null) shouldBe true
        client.subscriber.unsubscribe("/t1", "")
        client.subscriber.subscribe("/t2000", "", 0, 0, null) shouldBe true
        client.handled.shouldBeEmpty()
        client.pings.size shouldBeLessThan 1
    }
})
