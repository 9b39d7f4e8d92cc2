package argo.fleet

import argo.fleet.cluster.Overloaded
import argo.fleet.cluster.Refused
import argo.fleet.node.Claim
import argo.fleet.node.Directory
import argo.fleet.node.Fleet
import argo.fleet.node.FleetMessage
import argo.fleet.node.Grant
import argo.fleet.node.Kill
import argo.fleet.node.LeasedAgents
import argo.fleet.node.LocalAgents
import argo.fleet.node.MindNews
import argo.fleet.node.Reign
import argo.fleet.node.RosterNews
import argo.fleet.node.Say
import argo.fleet.node.Stop
import argo.fleet.node.Takeover
import argo.fleet.node.Unanswered
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import jason.asSemantics.Agent
import jason.asSemantics.Event
import kotlinx.coroutines.delay
import java.io.IOException
import java.util.Queue
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicBoolean
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicLong
import java.util.logging.Logger
import kotlin.time.Duration.Companion.seconds

/** An agent that outlives its computer, on one of three computers in real time. The test plays the other two. */
@Tags("Thorough")
class TakeoverSpec : FunSpec({
    test("a computer that is granted an agent gets to know the agent's mind first, if it does not know it") {
        OneComputer("m at \"scout1, base\";", "m" to "").use { base ->
            val sent = CopyOnWriteArrayList<FleetMessage>()
            base.cluster.answer = { one ->
                sent += one.message
                one.end.complete(null)
            }
            base.cluster.view("scout1" to "1")
            val mind = MindNews("m", 1, 7, "counted(7).")
            base.cluster.receives("scout1", mind)
            eventually(60.seconds) { // a computer grants nothing shortly after its start
                base.cluster.receives("scout1", Claim("m", 1, 2))
                sent shouldContain Grant("m", 1, 2, true)
            }
            sent[sent.indexOf(Grant("m", 1, 2, true)) - 1] shouldBe mind
            sent.clear()
            base.cluster.receives("scout1", Claim("m", 2, 2, mindTerm = 1, mindNumber = 7))
            sent shouldBe listOf(Grant("m", 2, 2, true))
        }
    }

    test("a computer by whose project the agent outlives no computer is told once") {
        OneComputer("m at \"base, scout1\";", "m" to "").use { base ->
            val refusal = "m outlives no computer by the project of scout1; all computers need the same project"
            val claims = AtomicInteger()
            base.cluster.answer = { one ->
                if (one.message is Claim) one.end.completeExceptionally(Refused("not_leased", refusal)) else one.end.complete(null)
                if (one.message is Claim) claims.incrementAndGet()
            }
            base.cluster.view("scout1" to "1")
            eventually(60.seconds) { claims.get() shouldBeGreaterThan 2 }
            base.logged("does not let m run here") shouldBe listOf("scout1 does not let m run here: $refusal")
        }
    }

    test("the next computer runs it with its mind when most grant that, and stops it when they do not any more") {
        OneComputer("m at \"scout1, base\";", "m" to "").use { base ->
            base.cluster.view("scout1" to "1", "scout2" to "1")
            base.cluster.receives("scout1", MindNews("m", 1, 7, "counted(7)."))
            val isGranting = AtomicBoolean(true)
            base.cluster.answer = { one ->
                val claim = one.message as? Claim
                one.end.complete(null)
                if (claim != null && isGranting.get()) base.cluster.receives(one.to, Grant("m", claim.number, claim.term, true))
            }
            base.cluster.view("scout2" to "1")
            base.shouldBelieve("m", "counted(7)")
            isGranting.set(false)
            base.shouldLog("m stops here: most computers of the fleet have not confirmed in time")
            eventually(60.seconds) { base.believed("m") shouldBe emptyList() }
        }
    }

    test("a computer that cannot start it gives it up, so that the next one runs it") {
        OneComputer("m missing.asl at \"base, scout1\";").use { base ->
            val isAble = AtomicBoolean(true)
            base.cluster.answer = { one ->
                one.end.complete(null)
                (one.message as? Claim)?.let { base.cluster.receives(one.to, Grant("m", it.number, it.term, true)) }
                if ((one.message as? RosterNews)?.unable == setOf("m")) isAble.set(false)
            }
            base.cluster.view("scout1" to "1", "scout2" to "1")
            eventually(60.seconds) { isAble.get() shouldBe false }
            val claims = CopyOnWriteArrayList<FleetMessage>()
            base.cluster.answer = { one ->
                one.end.complete(null)
                claims += one.message
            }
            delay(1.seconds) // the time of three claims
            claims shouldBe emptyList()
        }
    }

    suspend fun shouldGiveUp(agentClass: String, program: String, reason: String) {
        val isUnable = AtomicBoolean()
        OneComputer("m agentClass argo.fleet.$agentClass at \"base, scout1\";", "m" to program).use { base ->
            base.cluster.answer = { one ->
                one.end.complete(null)
                if ((one.message as? RosterNews)?.unable == setOf("m")) isUnable.set(true)
                (one.message as? Claim)?.let { base.cluster.receives(one.to, Grant("m", it.number, it.term, true)) }
            }
            base.cluster.view("scout1" to "1", "scout2" to "1")
            base.shouldLog("m cannot run here: $reason; if no other computer runs it")
            isUnable.get() shouldBe true
            eventually(20.seconds) { base.believed("m") shouldBe emptyList() }
        }
    }

    test("an agent for which the machine has no thread left is given up, and the log tells when it is tried again") {
        shouldGiveUp("ThreadlessAgent", "place(north).", "unable to create native thread")
    }

    test("an agent whose thread ends with an error is given up, so that the next computer runs it") {
        shouldGiveUp("FailingAgent", "!go. +!go.", "it needs a class that is not there")
    }

    test("an agent that could not be started is tried again, and the same reason is told once") {
        val now = AtomicLong()
        val cluster = FakeCluster("base")
        val fleet = Fleet(cluster, mapOf("m" to listOf("base", "scout1")), emptyMap(), Logger.getLogger("argo.test.retry"))
        val told = CopyOnWriteArrayList<String>()
        val log = Logger.getLogger("argo.test.takeover").apply { setFilter { told.add(it.message) && false } }
        val starts = AtomicInteger()
        lateinit var takeover: Takeover
        val agents = object : LeasedAgents {
            override fun start(agent: String, reign: Reign, mind: MindNews?) {
                if (starts.incrementAndGet() < 3) takeover.cannotRun(agent, reign, IOException("there is no m.asl"))
            }

            override fun stop(agent: String) = Unit
        }
        takeover = Takeover(fleet, mapOf("m" to listOf("base", "scout1")), 3, agents, log, now::get)
        takeover.use {
            fleet.join(Nobody, takeover)
            cluster.answer = { one ->
                one.end.complete(null)
                (one.message as? Claim)?.let { cluster.receives(one.to, Grant("m", it.number, it.term, true)) }
            }
            cluster.view("scout1" to "1", "scout2" to "1")
            takeover.begin()
            eventually(60.seconds) {
                now.addAndGet(1_000_000_000)
                starts.get() shouldBe 3
            }
            told.filter { "there is no m.asl" in it }.size shouldBe 1
        }
    }

    test("the mind is told again until all have it") {
        OneComputer("m at \"base, scout1\";", "m" to "place(north).").use { base ->
            val minds = CopyOnWriteArrayList<MindNews>()
            base.cluster.answer = { one ->
                (one.message as? MindNews)?.let(minds::add)
                if (one.message is MindNews && minds.size < 3) one.end.completeExceptionally(Overloaded("too much waits"))
                else one.end.complete(null)
                (one.message as? Claim)?.let { base.cluster.receives(one.to, Grant("m", it.number, it.term, true)) }
            }
            base.cluster.view("scout1" to "1", "scout2" to "1")
            eventually(60.seconds) { minds.size shouldBe 4 }
            base.shouldLog("has not got what m believes, and is told again: too much waits")
        }
    }

    test("a right that ends and is granted again while the agent is being created has the agent run") {
        LateAgent.hold()
        OneComputer("m agentClass argo.fleet.LateAgent at \"base, scout1\";", "m" to "place(north).").use { base ->
            val isGone = CountDownLatch(1)
            var granted = 0L // the time of the last claim that was granted at once
            base.cluster.answer = { one ->
                one.end.complete(null)
                if ((one.message as? RosterNews)?.gone == setOf("m")) isGone.countDown()
                (one.message as? Claim)?.let { claim ->
                    val age = (System.nanoTime() - granted) / 1_000_000
                    if (!LateAgent.isHeld()) granted = System.nanoTime()
                    else if (age < 1100) return@let
                    else { // the takeover's thread waits here, so it does not notice that the right ends
                        Thread.sleep(maxOf(0, 1450 - age))
                        LateAgent.release()
                        isGone.await(60, TimeUnit.SECONDS)
                    }
                    base.cluster.receives(one.to, Grant("m", claim.number, claim.term, true))
                }
            }
            base.cluster.view("scout1" to "1", "scout2" to "1")
            isGone.await(60, TimeUnit.SECONDS) shouldBe true
            base.shouldBelieve("m", "place(north)[source(self)]")
        }
    }

    test("an agent that is still being created when this computer has the right to it again is created once more, and runs once") {
        LateAgent.hold()
        OneComputer("m agentClass argo.fleet.LateAgent at \"base, scout1\";", "m" to "place(north).").use { base ->
            val isGranting = AtomicBoolean(true)
            val (claimed, granted) = AtomicLong() to AtomicLong() // the terms of the last claim and of the last granted claim
            base.cluster.answer = { one ->
                one.end.complete(null)
                (one.message as? Claim)?.let { claim ->
                    claimed.set(claim.term)
                    if (isGranting.get()) {
                        base.cluster.receives(one.to, Grant("m", claim.number, claim.term, true))
                        granted.set(claim.term)
                    }
                }
            }
            base.cluster.view("scout1" to "1", "scout2" to "1")
            eventually(60.seconds) { LateAgent.isHeld() shouldBe true }
            isGranting.set(false)
            val before = granted.get()
            eventually(60.seconds) { claimed.get() shouldBeGreaterThan before } // the computer has given up its first reign
            isGranting.set(true)
            eventually(60.seconds) { granted.get() shouldBeGreaterThan before }
            LateAgent.release()
            base.shouldBelieve("m", "place(north)[source(self)]")
            delay(1.seconds) // the first reign and the second would have ended by then
            base.believed("m") shouldContain "place(north)[source(self)]"
        }
    }
})

internal object Nobody : LocalAgents {
    override fun take(message: Say) = Unit
    override fun take(message: Unanswered) = Unit
    override fun kill(wanted: Kill) = Unit
    override fun stop(wanted: Stop) = Unit
    override fun directoryChanged(before: Directory, now: Directory) = Unit
    override fun refused(reason: String) = Unit
}

/** An agent without threads on its machine. The creating thread cannot make another thread. */
class ThreadlessAgent : Agent() {
    override fun initAg() {
        super.initAg()
        NO_THREAD.set(Unit)
    }

    private companion object {
        val NO_THREAD = object : InheritableThreadLocal<Unit>() {
            override fun childValue(parent: Unit?): Unit = throw OutOfMemoryError("unable to create native thread")
        }
    }
}

/** An agent whose selection of an event throws an error. */
class FailingAgent : Agent() {
    override fun selectEvent(events: Queue<Event>): Event = throw NoClassDefFoundError("it needs a class that is not there")
}

/** An agent whose first instance is created only when a test allows it. */
class LateAgent : Agent() {
    override fun initAg() {
        held?.let {
            isHeld.set(true)
            it.await()
        }
        super.initAg()
    }

    companion object {
        @Volatile
        private var held: CountDownLatch? = null
        private val isHeld = AtomicBoolean()

        fun hold() {
            held = CountDownLatch(1)
        }

        fun isHeld() = isHeld.get()

        fun release() {
            isHeld.set(false)
            val latch = held
            held = null
            latch?.countDown()
        }
    }
}
