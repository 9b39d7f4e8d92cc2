package argo.perception

import argo.acting.CommandLedger
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import jason.asSemantics.Event
import jason.asSemantics.IntendedMeans
import jason.asSemantics.Intention
import jason.asSemantics.Option
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Plan
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit

private object Robot

class HandOverSpec : FunSpec({
    fun percept(trigger: String) = Event(ASSyntax.parseTrigger(trigger), Intention.EmptyInt)
    fun intention(trigger: String) = Intention().apply {
        push(IntendedMeans(Option(Plan(null, ASSyntax.parseTrigger(trigger), null, null), Unifier()), ASSyntax.parseTrigger(trigger)))
    }
    fun snapshot(n: Long, event: String? = null): Snapshot {
        val state = Snapshot(null, listOf("n($n)"), listOf("n($n)"), emptyList(), n)
        return if (event == null) state else state.with(PerceptEvent(listOf(event), emptyList()))
    }

    context("fresh") {
        test("gives the newest snapshot, once") {
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }))
            handOver.take() shouldBe null
            handOver.put(snapshot(1))
            handOver.put(snapshot(2))
            handOver.isReady() shouldBe true
            handOver.take()?.receivedNanos shouldBe 2
            handOver.take() shouldBe null
        }

        test("gives each event in its turn, together with the newest of all else") {
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }))
            for (n in 1L..4) handOver.put(snapshot(n, if (n in 2..3) "e($n)" else null))
            handOver.take()?.texts shouldBe listOf("n(4)", "e(2)")
            handOver.put(snapshot(5))
            generateSequence(handOver::take).map { it.texts }.toList() shouldBe listOf(listOf("n(5)", "e(3)"))
            handOver.put(snapshot(6, "e(6)"))
            handOver.put(snapshot(7, "e(7)"))
            generateSequence(handOver::take).map { it.texts }.toList() shouldBe listOf(listOf("n(7)", "e(6)"), listOf("n(7)", "e(7)"))
        }

        test("of more events than may wait the oldest are lost, and counted") {
            val told = ArrayList<Long>()
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }), told::add)
            for (n in 1L..FreshHandOver.MAX_EVENTS + 2) handOver.put(snapshot(n, "e($n)"))
            handOver.take()?.texts?.last() shouldBe "e(3)"
            told shouldBe listOf(1L, 2L)
        }

        test("tells of a loss without its lock, so that a log which stands holds up no other thread") {
            lateinit var handOver: FreshHandOver
            fun onAnotherThread(): Boolean = CompletableFuture.supplyAsync { handOver.isUrgent() }.get(20, TimeUnit.SECONDS)
            handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }), tellLost = { onAnotherThread() shouldBe false })
            for (n in 1L..FreshHandOver.MAX_EVENTS + 1) handOver.put(snapshot(n, "e($n)"))
        }

        test("waits while percept events of the one before are in the queue") {
            val queue = ArrayDeque<Event>()
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }, ReasoningQueues { queue }))
            handOver.put(snapshot(1))
            handOver.take()?.receivedNanos shouldBe 1
            queue += listOf(percept("+dist(f,1)[source(percept)]"), percept("-dist(f,2)[source(percept)]"))
            handOver.put(snapshot(2))
            handOver.isReady() shouldBe false
            queue.removeFirst()
            handOver.take() shouldBe null
            queue += percept("+weather(rain)[source(percept)]") // belongs to a later perception
            queue.removeFirst()
            handOver.take()?.receivedNanos shouldBe 2
        }

        test("a look from another thread before the snapshot has been taken in does not let its events go unawaited") {
            val queue = ArrayDeque<Event>()
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }, ReasoningQueues { queue }))
            handOver.put(snapshot(1))
            handOver.take()?.receivedNanos shouldBe 1
            handOver.put(snapshot(2))
            handOver.isReady()
            queue += percept("+dist(f,1)[source(percept)]")
            handOver.take() shouldBe null
            queue.clear()
            handOver.take()?.receivedNanos shouldBe 2
        }

        test("a long queue, as an atomic plan leaves it, is not gone through in each perception") {
            var looks = 0
            val events = ArrayDeque<Event>()
            val queue = object : AbstractCollection<Event>() {
                override val size get() = events.size
                override fun iterator() = events.asSequence().onEach { looks++ }.iterator()
            }
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }, ReasoningQueues { queue }))
            handOver.put(snapshot(1))
            handOver.take()
            repeat(1_000) { events += percept("+dist(f,$it)[source(percept)]") }
            handOver.put(snapshot(2))
            while (handOver.take() == null) events.removeFirst()
            events.size shouldBe 0
            check(looks < 10_000) { "$looks looks at 1000 events" }
        }

        test("a snapshot of an older message does not take the place of a newer one") {
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }))
            handOver.put(snapshot(2))
            handOver.put(snapshot(1))
            handOver.take()?.receivedNanos shouldBe 2
        }

        test("other events than those of percepts are nothing to wait for") {
            val queue = ArrayDeque<Event>()
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }, ReasoningQueues { queue }))
            handOver.put(snapshot(1))
            handOver.take()
            queue += listOf(percept("+!go"), percept("+told(x)[source(bob)]"))
            handOver.put(snapshot(2))
            handOver.take()?.receivedNanos shouldBe 2
        }

        test("while Jason takes no events, as in an atomic plan, it waits a while instead, so that not too many pile up") {
            val queue = ArrayDeque<Event>()
            var stands = true
            var nowMs = 0L
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }, ReasoningQueues({ stands }) { queue }, { nowMs }))
            handOver.put(snapshot(1))
            handOver.take()
            queue += percept("+dist(f,1)[source(percept)]")
            handOver.put(snapshot(2))
            nowMs = 99
            handOver.take() shouldBe null
            nowMs = 100
            handOver.take()?.receivedNanos shouldBe 2
            stands = false
            handOver.put(snapshot(3))
            handOver.take() shouldBe null
        }

        test("waits until the intentions that percepts have begun have finished or wait, and for no others") {
            val running = ArrayDeque(listOf(intention("+!drive"), intention("+dist(f,1)[source(percept)]")))
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }, ReasoningQueues(running = { running }), { 0 }))
            handOver.put(snapshot(1))
            handOver.isReady() shouldBe false
            handOver.take() shouldBe null
            running.removeLast()
            handOver.take()?.receivedNanos shouldBe 1
        }

        test("does not wait for an intention that has finished and has not been removed yet") {
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }, ReasoningQueues(running = { listOf(Intention()) }), { 0 }))
            handOver.put(snapshot(1))
            handOver.isReady() shouldBe true
            handOver.take()?.receivedNanos shouldBe 1
        }

        test("does not wait for an intention that runs on") {
            var nowMs = 0L
            val running = listOf(intention("+dist(f,1)[source(percept)]"))
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }, ReasoningQueues(running = { running }), { nowMs }))
            handOver.put(snapshot(1))
            handOver.take() shouldBe null
            nowMs = UnfinishedWork.LONG_MS
            handOver.take()?.receivedNanos shouldBe 1
            handOver.put(snapshot(2))
            handOver.take()?.receivedNanos shouldBe 2
        }

        test("waits for the commands issued before the last hand-over and for no others") {
            val ledger = CommandLedger { Robot }
            val handOver = FreshHandOver(UnfinishedWork(ledger))
            val first = ledger.issue(Robot)
            handOver.put(snapshot(1))
            handOver.take()?.receivedNanos shouldBe 1 // no hand-over comes before the first one
            val second = ledger.issue(Robot)
            handOver.put(snapshot(2))
            handOver.take() shouldBe null
            ledger.done(Robot, first)
            handOver.take()?.receivedNanos shouldBe 2 // the second command was issued after the last hand-over
            handOver.put(snapshot(3))
            handOver.take() shouldBe null
            ledger.done(Robot, second)
            handOver.take()?.receivedNanos shouldBe 3
        }

        test("does not wait for commands to a port that is not in use, whenever they were issued") {
            val other = Any()
            var inUse: Any? = other
            val ledger = CommandLedger { inUse }
            val handOver = FreshHandOver(UnfinishedWork(ledger))
            ledger.issue(other)
            handOver.put(snapshot(1))
            handOver.take()
            handOver.put(snapshot(2))
            handOver.take() shouldBe null
            inUse = Robot
            handOver.take()?.receivedNanos shouldBe 2
            ledger.issue(other) // a plan asked for the port before the port changed
            handOver.put(snapshot(3))
            handOver.take()?.receivedNanos shouldBe 3
            handOver.put(snapshot(4))
            handOver.take()?.receivedNanos shouldBe 4
            val own = ledger.issue(Robot)
            handOver.put(snapshot(5))
            handOver.take()?.receivedNanos shouldBe 5
            handOver.put(snapshot(6))
            handOver.take() shouldBe null
            ledger.done(Robot, own)
            handOver.take()?.receivedNanos shouldBe 6
        }

        test("tells that snapshots wait for long, and for which work") {
            val ledger = CommandLedger { Robot }
            val told = mutableListOf<String>()
            val handOver = FreshHandOver(UnfinishedWork(ledger)) { ms, why -> told += "$ms ms: $why" }
            fun put(ms: Long) = handOver.put(snapshot(ms * 1_000_000))
            put(0)
            put(9_000) // nothing is left, so only the agent is slow
            handOver.take()
            val command = ledger.issue(Robot)
            put(9_100)
            handOver.take()
            put(9_200)
            put(11_000)
            told shouldBe emptyList()
            put(11_300)
            told shouldBe listOf("2100 ms: commands issued before the last percepts have not left")
            ledger.done(Robot, command)
            handOver.take()
            put(20_000)
            told.size shouldBe 1
        }

        test("after the agent was paused, the newest is taken next whatever work is left, and none before it") {
            val ledger = CommandLedger { Robot }
            val handOver = FreshHandOver(UnfinishedWork(ledger))
            ledger.issue(Robot)
            handOver.put(snapshot(1))
            handOver.take()
            handOver.put(snapshot(2))
            handOver.put(snapshot(3))
            handOver.isReady() shouldBe false
            handOver.catchUp() shouldBe 0
            (handOver.isReady() to handOver.isUrgent()) shouldBe (true to true)
            handOver.take()?.receivedNanos shouldBe 3
            handOver.put(snapshot(4))
            handOver.isReady() shouldBe false
        }

        test("a plan that always has a command on its way does not starve it") {
            val ledger = CommandLedger { Robot }
            val handOver = FreshHandOver(UnfinishedWork(ledger))
            var taken = 0
            var onItsWay = ledger.issue(Robot)
            repeat(100) { n ->
                handOver.put(snapshot(n.toLong()))
                if (handOver.take() != null) taken++
                val next = ledger.issue(Robot)
                ledger.done(Robot, onItsWay)
                onItsWay = next
            }
            check(taken >= 49) { "$taken of 100 taken" }
        }

        test("what is cleared is never taken") {
            val handOver = FreshHandOver(UnfinishedWork(CommandLedger { Robot }))
            handOver.put(snapshot(1))
            handOver.clear()
            handOver.take() shouldBe null
        }
    }

    context("every") {
        test("gives each snapshot in its order") {
            val handOver = EveryHandOver { error(it) }
            (1L..10).forEach { handOver.put(snapshot(it)) }
            (1L..10).map { handOver.take()?.receivedNanos } shouldBe (1L..10).toList()
            handOver.take() shouldBe null
        }

        test("after the agent was paused gives the newest only, and counts the others") {
            val handOver = EveryHandOver { }
            for (n in 1L..5) handOver.put(snapshot(n))
            handOver.catchUp() shouldBe 4
            handOver.take()?.receivedNanos shouldBe 5
            handOver.catchUp() shouldBe 0
            handOver.take() shouldBe null
        }

        test("gives none while too many events wait, and loses none for that") {
            var isCrowded = true
            val handOver = EveryHandOver({ isCrowded }) { error(it) }
            (1L..3).forEach { handOver.put(snapshot(it)) }
            handOver.isReady() shouldBe false
            handOver.take() shouldBe null
            isCrowded = false
            handOver.take()?.receivedNanos shouldBe 1
            isCrowded = true
            handOver.drain().map { it.receivedNanos } shouldBe listOf(2L, 3L)
        }

        test("is bounded, and says so once") {
            val warnings = ArrayList<String>()
            val handOver = EveryHandOver { warnings += it }
            (1L..2000).forEach { handOver.put(snapshot(it)) }
            handOver.take()?.receivedNanos shouldBe 1001
            warnings.size shouldBe 1
        }
    }

    test("the ledger knows for any order of completion whether all commands up to one are done") {
        checkAll(Arb.list(Arb.element(true, false), 1..40)) { steps ->
            val ledger = CommandLedger { Robot }
            val pending = ArrayList<Long>()
            for (issue in steps) {
                if (issue || pending.isEmpty()) pending += ledger.issue(Robot) else ledger.done(Robot, pending.removeAt(pending.size / 2))
                for (mark in 0..ledger.lastIssued()) ledger.allDoneUpTo(mark) shouldBe pending.none { it <= mark }
            }
        }
    }
})
