package argo.fleet.cluster

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import java.util.concurrent.CompletionException
import java.util.concurrent.CompletionStage
import io.kotest.matchers.string.shouldContain as shouldContainText

/** The computers `a`, `b` and `c` of a fleet, which a test can start and crash. */
internal interface ClusterWorld : AutoCloseable {
    /** Starts the program of a computer. The computer does not join. */
    fun start(name: String): Cluster

    /** Ends the program of a computer abruptly. */
    fun crash(name: String)

    /** Waits until [condition] holds. */
    fun await(what: String, condition: () -> Boolean)
}

/** The contract of each cluster, over sockets and in memory. */
internal fun clusterContract(world: () -> ClusterWorld): FunSpec.() -> Unit = {
    fun ClusterWorld.joined(name: String): Pair<Cluster, Log> {
        val cluster = start(name)
        val log = Log()
        cluster.listen(log)
        return cluster to log
    }

    fun ClusterWorld.end(stage: CompletionStage<Void>): Throwable? {
        val future = stage.toCompletableFuture()
        await("the end of a message") { future.isDone }
        return runCatching { future.join() }.exceptionOrNull()?.let { if (it is CompletionException) it.cause else it }
    }

    fun ClusterWorld.awaitView(vararg names: String, of: List<Log>) =
        await("a view of ${names.toList()}, not ${of.map { it.computers }}") { of.all { it.computers == names.toSet() } }

    test("computers find each other, and know whether they are the majority").config(blockingTest = true) {
        world().use { world ->
            val (a, log) = world.joined("a")
            world.awaitView("a", of = listOf(log))
            log.views.last().hasMajority shouldBe false
            val (_, other) = world.joined("b")
            world.awaitView("a", "b", of = listOf(log, other))
            val (here, there) = listOf(log, other).map { it.views.last() }
            listOf(here, there).map { it.hasMajority } shouldBe listOf(true, true)
            here.computers.getValue("b") shouldBe there.computers.getValue("b")
            shouldThrow<IllegalStateException> { a.listen(log) }
        }
    }

    test("messages arrive once and in order, long and empty ones too").config(blockingTest = true) {
        world().use { world ->
            val (a, log) = world.joined("a")
            val (_, other) = world.joined("b")
            world.awaitView("a", "b", of = listOf(log, other))
            val texts = (0 until 3000).map { if (it % 100 == 0) "x".repeat(it * 50) else "$it" }
            val ends = texts.map { a.send("b", it.toByteArray()) }
            ends.forEach { world.end(it) shouldBe null }
            (other.from("a") == texts) shouldBe true
            world.end(a.send("a", "to myself".toByteArray())) shouldBe null
            log.from("a") shouldBe listOf("to myself")
        }
    }

    test("a message to a computer that is not there, or that is lost, fails").config(blockingTest = true) {
        world().use { world ->
            val (a, log) = world.joined("a")
            world.end(a.send("b", "x".toByteArray())).shouldBeInstanceOf<Unreachable>().message shouldBe
                "the computer b is not in touch with a"
            val (_, other) = world.joined("b")
            world.awaitView("a", "b", of = listOf(log, other))
            world.crash("b")
            val end = world.end(a.send("b", "x".toByteArray()))
            end.shouldBeInstanceOf<Unreachable>()
            world.awaitView("a", of = listOf(log))
        }
    }

    test("a message that the listener does not want is refused, and the next one is not").config(blockingTest = true) {
        world().use { world ->
            val (a, log) = world.joined("a")
            val (_, other) = world.joined("b")
            world.awaitView("a", "b", of = listOf(log, other))
            val ends = listOf("yes", "no", "yes").map { a.send("b", it.toByteArray()) }
            ends.map { world.end(it) as Refused? }.map { it?.error to it?.message } shouldBe
                listOf(null to null, "unwanted" to "I do not want it", null to null)
            other.from("a") shouldBe listOf("yes", "yes")
        }
    }

    test("a computer that starts again is another session, and gets what is sent to it").config(blockingTest = true) {
        world().use { world ->
            val (a, log) = world.joined("a")
            val (_, other) = world.joined("b")
            world.awaitView("a", "b", of = listOf(log, other))
            world.end(a.send("b", "1".toByteArray())) shouldBe null
            val first = other.views.last().computers.getValue("b").session
            world.crash("b")
            val (_, again) = world.joined("b")
            world.await("another session") { log.views.last().computers["b"]?.session.let { it != null && it != first } }
            world.awaitView("a", "b", of = listOf(again))
            world.end(a.send("b", "2".toByteArray())) shouldBe null
            again.from("a") shouldBe listOf("2")
        }
    }

    test("whoever leaves is gone at once, and its messages fail").config(blockingTest = true) {
        world().use { world ->
            val (_, log) = world.joined("a")
            val (b, other) = world.joined("b")
            world.awaitView("a", "b", of = listOf(log, other))
            b.close()
            world.awaitView("a", of = listOf(log))
            world.end(b.send("a", "x".toByteArray())).shouldBeInstanceOf<Unreachable>()
            log.refusals.shouldBeEmpty()
        }
    }

    test("of two computers with one name the newer one is refused, and gets nothing until then").config(blockingTest = true) {
        world().use { world ->
            val (_, log) = world.joined("a")
            val (b, third) = world.joined("b")
            world.awaitView("a", "b", of = listOf(log, third))
            val (_, other) = world.joined("a")
            world.end(b.send("a", "for the first".toByteArray())) shouldBe null
            log.from("b") shouldBe listOf("for the first")
            world.await("a refusal") { other.refusals.isNotEmpty() }
            other.refusals.single() shouldContainText "is called a already"
            log.refusals.shouldBeEmpty()
            other.messages.shouldBeEmpty()
        }
    }
}
