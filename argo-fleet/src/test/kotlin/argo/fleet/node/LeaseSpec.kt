package argo.fleet.node

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.long
import io.kotest.property.checkAll
import java.util.PriorityQueue
import kotlin.random.Random

/** The right to run an agent that outlives its computer: never two have it. In virtual time. */
class LeaseSpec : FunSpec({
    test("a computer that most have granted it may run the agent, and no longer than it renews that") {
        val world = World(3, Random(1)).apply { advance(Lease.DURATION_NS) }
        world.claim(0)
        world.advance(10 * MS)
        world.running() shouldBe listOf(0)
        world.advance(Lease.DURATION_NS)
        world.running() shouldBe emptyList()
    }

    test("a computer that was suspended may not run it when it goes on, though its clock stood still meanwhile") {
        val world = World(3, Random(1)).apply { advance(Lease.DURATION_NS) }
        world.claim(0)
        world.advance(10 * MS)
        world.suspendedMs = 60_000
        world.running() shouldBe emptyList()
    }

    test("while one has it, others ask in vain; when it is silent, the next one gets it under a greater term") {
        val world = World(3, Random(1)).apply { advance(Lease.DURATION_NS) }
        world.claim(0)
        world.advance(10 * MS)
        world.claim(1)
        world.advance(10 * MS)
        world.running() shouldBe listOf(0)
        val first = world.leases[0].ownTerm
        world.cut(0)
        world.advance(2 * Lease.DURATION_NS)
        repeat(2) { // the first claim may have an old term
            world.claim(1)
            world.advance(10 * MS)
        }
        world.running() shouldBe listOf(1)
        world.leases[1].ownTerm shouldBeGreaterThan first
    }

    test("a computer whose term most have granted to another gets the agent in a later term, when that other is silent") {
        val world = World(3, Random(1)).apply { advance(Lease.DURATION_NS) }
        world.cut(0)
        world.claim(0) // it promises itself the term that the others grant now
        repeat(3) { // messages may be lost
            world.claim(1)
            world.advance(30 * MS)
        }
        world.running() shouldBe listOf(1)
        world.advance(2 * Lease.DURATION_NS)
        world.join(0)
        repeat(10) {
            world.claim(0)
            world.advance(30 * MS)
        }
        world.running() shouldBe listOf(0)
    }

    test("a computer that gives up a term that it has not granted itself begins a later one") {
        val lease = Lease(3, 0, 0, nanos = { 0 }, wallMs = { 0 })
        val first = lease.claim("m").term
        lease.giveUp()
        lease.claim("m").term shouldBeGreaterThan first
    }

    test("a computer that has just begun grants nothing, since it may have promised it before") {
        val world = World(3, Random(1))
        world.claim(0)
        world.advance(10 * MS)
        world.running() shouldBe emptyList()
    }

    test("whatever has happened before, a computer that asks again and again gets it while most hear it") {
        checkAll(200, Arb.long()) { seed ->
            val random = Random(seed)
            val computers = random.nextInt(3, 6)
            val world = World(computers, random)
            repeat(random.nextInt(40)) { world.step() }
            (0..computers / 2).forEach(world::join)
            (computers / 2 + 1..<computers).forEach(world::cut)
            withClue("seed $seed") { world.isGranted(0) shouldBe true }
        }
    }

    test("however messages are delayed, lost and doubled, computers cut off, stopped and started anew, never two may run it") {
        var reigns = 0
        checkAll(200, Arb.long()) { seed ->
            val random = Random(seed)
            val world = World(random.nextInt(2, 6), random)
            repeat(400) {
                world.step()
                withClue("seed $seed") { world.running().size shouldBe world.running().take(1).size }
            }
            reigns += world.leases.maxOf { it.term }.toInt()
        }
        reigns shouldBeGreaterThan 200
    }
})

private const val MS = 1_000_000L

/** Computers that claim one agent, and the messages among them. */
private class World(private val computers: Int, private val random: Random) {
    private class Sent(val arrivesNs: Long, val act: () -> Unit)

    private var nowNs = 1_000_000_000L
    private val under = PriorityQueue<Sent>(compareBy { it.arrivesNs })
    private val isCut = BooleanArray(computers)
    val leases = MutableList(computers) { begun() }

    /** The time that the computers were suspended, in ms: their other clock stood still. */
    var suspendedMs = 0L

    private fun begun() = Lease(computers, nowNs, random.nextLong(), { nowNs }) { nowNs / MS + suspendedMs }

    fun running(): List<Int> = leases.indices.filter { leases[it].mayRun() }

    fun cut(computer: Int) {
        isCut[computer] = true
    }

    fun join(computer: Int) {
        isCut[computer] = false
    }

    /** Has the computer [from] claim as [Takeover] does; returns whether it has the right at last. */
    fun isGranted(from: Int): Boolean = (1..40).any {
        claim(from)
        advance(300 * MS)
        running() == listOf(from)
    }

    fun advance(ns: Long) {
        val end = nowNs + ns
        while (under.isNotEmpty() && under.peek().arrivesNs <= end) {
            val sent = under.remove()
            nowNs = maxOf(nowNs, sent.arrivesNs)
            sent.act()
        }
        nowNs = end
    }

    fun claim(from: Int) {
        val claim = leases[from].claim("a")
        leases.indices.forEach { to ->
            send(from, to) {
                val grant = leases[to].answer("c$from", claim)
                send(to, from) { leases[from].take("c$to", grant) }
            }
        }
    }

    private fun send(from: Int, to: Int, act: () -> Unit) {
        if (from == to) return act()
        if (isCut[from] || isCut[to] || random.nextInt(20) == 0) return
        val delay = if (random.nextInt(10) == 0) random.nextLong(3000) else random.nextLong(20)
        under += Sent(nowNs + delay * MS, act)
    }

    fun step() {
        val computer = random.nextInt(computers)
        when (random.nextInt(40)) {
            0 -> isCut[computer] = !isCut[computer]
            1 -> leases[computer] = begun()
            2 -> leases[computer].giveUp()
            else -> claim(computer)
        }
        advance(random.nextLong(200) * MS)
    }
}
