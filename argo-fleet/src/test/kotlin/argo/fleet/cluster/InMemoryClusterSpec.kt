package argo.fleet.cluster

import argo.fleet.trial.Event
import argo.fleet.trial.History
import argo.fleet.trial.Kind
import argo.fleet.trial.Notes
import io.kotest.assertions.withClue
import io.kotest.core.NamedTag
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import java.util.concurrent.CompletableFuture
import kotlin.random.Random
import kotlin.time.Duration.Companion.minutes

private class InMemoryWorld : ClusterWorld {
    private val network = InMemoryNetwork(setOf("a", "b", "c"))

    override fun start(name: String) = network.join(name)
    override fun crash(name: String) = network.crash(name)
    override fun close() = Unit

    override fun await(what: String, condition: () -> Boolean) {
        repeat(100) {
            network.run()
            if (condition()) return
            network.advance(100)
        }
        error("in vain: $what")
    }
}

class InMemoryClusterSpec : FunSpec({
    clusterContract(::InMemoryWorld)(this)

    suspend fun tryAtRandom(times: Int) {
        checkAll(times, Arb.int()) { seed ->
            val random = Random(seed)
            val names = listOf("a", "b", "c")
            val network = InMemoryNetwork(names.toSet()) { _, _ -> random.nextInt(20) == 0 }
            val events = mutableListOf<Event>()
            var starts = 0
            fun start(name: String) = "$name#${++starts}".let { it to Notes(network.join(name), it, events::add) }
            val computers = names.associateWith(::start).toMutableMap()
            repeat(60) {
                when (random.nextInt(12)) {
                    0 -> network.part(setOf(names.random(random)))
                    1, 2 -> network.heal()
                    3 -> names.random(random).let {
                        network.crash(it)
                        events += Event(System.nanoTime(), computers.getValue(it).first, Kind.CRASHED)
                        computers[it] = start(it)
                    }
                    else -> computers.values.random(random).second.let { computer ->
                        repeat(random.nextInt(1, 30)) {
                            computer.send(names.random(random), random.nextInt(100).takeIf { it > 0 } ?: 40_000)
                        }
                    }
                }
                if (random.nextBoolean()) network.run() else network.advance(random.nextLong(1000))
            }
            network.heal()
            network.advance(20_000)
            computers.values.forEach { it.second.finish() }
            withClue("seed $seed") { History(events).faults().shouldBeEmpty() }
        }
    }

    test("over a network that loses, parts, heals and restarts at random, each message is taken once and in order, or reported failed") {
        tryAtRandom(40)
    }

    test("the same, over and over").config(tags = setOf(NamedTag("Thorough")), timeout = 5.minutes) { tryAtRandom(2000) }

    test("if only one of two computers loses the other for a while, what it sent meanwhile fails, and the rest arrives once and in order") {
        val network = InMemoryNetwork(setOf("a", "b"))
        val events = mutableListOf<Event>()
        val (a, b) = listOf("a", "b").map { Notes(network.join(it), "$it#1", events::add) }
        network.run()
        repeat(3) {
            repeat(100) {
                a.send("b", 40_000)
                b.send("a", 10)
            }
            network.loseOneSided("a", "b")
            network.advance(1000)
        }
        listOf(a, b).forEach(Notes::finish)
        History(events).faults().shouldBeEmpty()
        events.count { it.kind == Kind.FAILED && it.session == "b#1" } shouldBe 0
        events.count { it.kind == Kind.TAKEN && it.session == "b#1" } shouldBe 300
    }

    test("completions and messages come in the order of their causes") {
        val network = InMemoryNetwork(setOf("a", "b"))
        val (a, b) = listOf("a", "b").map(network::join)
        val log = Log()
        a.listen(Log())
        b.listen(log)
        network.run()
        val order = mutableListOf<Int>()
        val ends = (0 until 10).map { n -> a.send("b", "$n".toByteArray()).thenRun { order += n }.toCompletableFuture() }
        network.run()
        CompletableFuture.allOf(*ends.toTypedArray()).isDone shouldBe true
        order shouldBe (0 until 10).toList()
    }
})
