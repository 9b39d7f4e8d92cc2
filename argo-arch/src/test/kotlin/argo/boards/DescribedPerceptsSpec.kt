package argo.boards

import argo.connecting.OpenPort
import argo.connecting.PortOptions
import argo.links.BoardLink
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.PerceptKind
import javino.PortFaultException
import javino.PortGoneException
import javino.PortInterruptedException
import javino.PortTimeoutException

/** The link to a board that describes its percepts. [answer] gets the time limit in ms. */
private class DescribingLink(val answer: DescribingLink.(Int) -> List<PerceptKind>) : BoardLink by RuleLink("robot") {
    override var isOpen = true
    override val isPaced get() = true
    val limits = ArrayList<Int>()

    override fun perceptKinds(timeoutMs: Int): List<PerceptKind> {
        limits += timeoutMs
        return answer(timeoutMs)
    }
}

class DescribedPerceptsSpec : FunSpec({
    val kinds = PerceptKind.parseLines("dist(cm 0..400)")
    val log = ArrayList<String>()

    fun described(link: BoardLink, timeoutMs: Int = 500) =
        DescribedPercepts(OpenPort(emptyMap(), link, PortOptions(timeoutMs = timeoutMs), 0, 0) { AutoCloseable { } }) { log += it }

    beforeTest { log.clear() }

    test("a board is asked once in each session, if somebody wants its kinds") {
        val link = DescribingLink { kinds }
        val described = described(link)
        described.askIfWanted()
        link.limits.shouldBeEmpty()
        described.get().shouldBeEmpty()
        repeat(2) { described.askIfWanted() }
        described.get() shouldBe kinds
        described.renew()
        described.askIfWanted()
        link.limits shouldContainExactly listOf(300, 300)
        log.shouldBeEmpty()
    }

    test("a board that does not describe its percepts in time is not asked again while the port is open, which the log tells once") {
        val troubles = listOf(PortTimeoutException("robot", "not within 80 ms"), PortFaultException("robot", "not within 80 ms", null))
        for (trouble in troubles) {
            log.clear()
            val link = DescribingLink { throw trouble }
            val described = described(link, timeoutMs = 80)
            described.get()
            repeat(3) {
                described.askIfWanted()
                described.renew()
            }
            described.get().shouldBeEmpty()
            link.limits shouldContainExactly listOf(80)
            log.single() shouldContain "not within 80 ms; it is not asked again until the port is opened anew"
        }
    }

    test("a link that has gone, and an interruption, are left to the sensing thread") {
        val gone = described(DescribingLink { isOpen = false; throw PortGoneException("robot", "port robot is gone") })
        gone.get()
        shouldThrow<PortGoneException> { gone.askIfWanted() }
        val interrupted = described(DescribingLink { throw PortInterruptedException("robot") })
        interrupted.get()
        shouldThrow<PortInterruptedException> { interrupted.askIfWanted() }
        log.shouldBeEmpty()
    }
})
