package argo.connecting

import argo.links.JavinoLink
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.longs.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax
import javino.link.Link
import javino.link.LinkSettings
import javino.sim.FakeBoard
import java.io.IOException
import java.util.concurrent.TimeUnit

class LostPortSpec : FunSpec({
    val term = ASSyntax.createAtom("robot")

    /** Makes a port that was open for [livedMs] and was lost at time 0, after [losses] earlier losses in a row. */
    fun lost(livedMs: Long, losses: Int = 0, spoke: Boolean = false): LostPort = FakeBoard.plugIn("lost").use { board ->
        JavinoLink(Link.open(board.port(), LinkSettings.defaults(), "bob")).use { link ->
            val port = OpenPort(
                mapOf(term to board.port()), link, PortOptions(), -TimeUnit.MILLISECONDS.toNanos(livedMs), losses,
            ) { AutoCloseable { } }
            port.hasSpoken = spoke
            LostPort(port, term, board.port(), 0)
        }
    }

    test("a device that is not there is looked for soon, and then about once a second") {
        val port = lost(livedMs = 60_000)
        val waits = (1..20).map {
            port.looked(present = false) shouldBe false
            port.nextLookMs()
        }
        waits.first() shouldBe 100
        waits.zipWithNext().forEach { (before, after) -> after shouldBeGreaterThan before - 1 }
        waits.last() shouldBeLessThanOrEqual 1000
        port.looked(present = true) shouldBe true
    }

    test("the first look opens nothing") {
        val port = lost(livedMs = 60_000)
        port.looked(present = true) shouldBe false
        port.nextLookMs() shouldBe 100
        port.looked(present = true) shouldBe true
    }

    test("a port that is lost again and again right after it was opened is opened ever more seldom") {
        val waits = (0..20).map { losses -> lost(livedMs = 10, losses).also { it.looked(present = true) }.nextLookMs() }
        waits.zipWithNext().forEach { (before, after) -> check(after >= before) { "$waits" } }
        waits.last() shouldBe 10_000
        lost(livedMs = 10, losses = 4).losses shouldBe 5
    }

    test("one that worked, or whose device was away in between, is not") {
        for (port in listOf(lost(livedMs = 60_000, losses = 9), lost(livedMs = 10, losses = 9, spoke = true))) {
            port.losses shouldBe 0
            port.looked(present = true)
            port.nextLookMs() shouldBe 100
        }
        val replugged = lost(livedMs = 10, losses = 9)
        replugged.looked(present = false)
        replugged.losses shouldBe 0
        replugged.nextLookMs() shouldBe 100
    }

    test("why it cannot be opened is told once for each kind of trouble, when it has stood for a while") {
        val port = lost(livedMs = 60_000)
        val told = (1..50).count { port.failed(IOException("no")) } to (1..50).count { port.failed(IllegalStateException("no")) }
        told shouldBe (1 to 1)
        lost(livedMs = 60_000).failed(IOException("not yet")) shouldBe false
    }
})
