package argo.tools.board

import argo.links.Answer
import argo.links.BoardLink
import argo.links.BoardLinkProvider
import argo.links.BoardMessage
import argo.links.Wish
import argo.tools.Output
import argo.tools.argo
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.ActionRefusedException
import javino.LineClock
import javino.NoSuchPortException
import javino.link.SendOptions
import javino.wire.BoardAction

/** Provides the scheme `elsewhere`, with one board and no serial line. */
class ElsewhereProvider : BoardLinkProvider {
    override val scheme = "elsewhere"

    override fun open(port: String, isPaced: Boolean, clock: LineClock): BoardLink =
        if (port == "elsewhere:robot") Elsewhere() else throw NoSuchPortException(port, "nothing listens at $port")
}

private class Elsewhere : BoardLink {
    private var said = 0
    private var isWanted = false
    override val port = "elsewhere:robot"
    override val isOpen = true
    override val isPaced = true
    override val speaksUnasked = true
    override val actions = listOf(BoardAction("stop", 0), BoardAction("move", 2))

    override fun wants(wish: Wish) {
        isWanted = wish.isSensed
    }

    override fun listen(timeoutMs: Int): BoardMessage? {
        Thread.sleep(1) // the interval between messages
        return if (isWanted && ++said % 2 == 0) BoardMessage("said($said);", System.nanoTime()) else null
    }

    override fun check() = Unit

    override fun send(text: String, options: SendOptions) = throw UnsupportedOperationException("the tools wait for an outcome")

    override fun sendAndAwait(text: String, options: SendOptions): Answer? = when (text) {
        "limit" -> Answer.of("${options.limitMillis()}")
        "stop" -> null
        "fly" -> throw ActionRefusedException(port, "the robot has no command fly")
        else -> Answer.of("[sum(3)]")
    }

    override fun close() = Unit
}

class BoardsElsewhereSpec : FunSpec({
    test("monitor listens to a board that is on no line") {
        val said = argo("monitor", "elsewhere:robot", "--count", "2", "--interval", "0")
        said.status shouldBe 0
        said.out shouldContain "said(2)"
        said.out shouldContain "said(4)"
        said.out shouldContain "the messages came over elsewhere"
    }
    test("monitor tells once that a board which is listened to is silent, and what it waits for") {
        argo("monitor", "elsewhere:robot", "--count", "3", "--timeout", "70").err shouldBe
            "port elsewhere:robot is there, and has had nothing to say for 70 ms; monitor goes on waiting for percepts\n"
    }
    test("monitor refuses a mode, since a board that is on no line is never asked") {
        argo("monitor", "elsewhere:robot", "--count", "1", "--mode", "request").let {
            it.status shouldBe 2
            it.err shouldContain "--mode is an option of lines, and elsewhere:robot is on none"
        }
    }
    test("send tells the answer, and why a command fails") {
        argo("send", "elsewhere:robot", "stop") shouldBe Output(0, "done\n", "")
        argo("send", "elsewhere:robot", "add(1,2)") shouldBe Output(0, "done; the answer is [sum(3)]\n", "")
        argo("send", "elsewhere:robot", "fly").let {
            it.status shouldBe 1
            it.err shouldContain "the robot has no command fly"
        }
    }
    test("send has a time limit if one is given, and refuses options of lines") {
        argo("send", "elsewhere:robot", "limit").out shouldBe "done; the answer is 0\n"
        argo("send", "elsewhere:robot", "limit", "--timeout", "70").out shouldBe "done; the answer is 70\n"
        argo("send", "elsewhere:robot", "stop", "--baud", "9600").let {
            it.status shouldBe 2
            it.err shouldContain "--baud is an option of lines, and elsewhere:robot is on none"
        }
    }
    test("ports --describe tells the actions and the percepts, and that there is no such board") {
        val lines = argo("ports", "--describe", "elsewhere:robot").out.lines()
        lines[0] shouldBe "elsewhere:robot: a board that is reached over elsewhere"
        lines[1] shouldBe "  actions: stop; move/2"
        lines[2] shouldContain "percepts: said("
        argo("ports", "--describe", "elsewhere:none").let {
            it.status shouldBe 1
            it.out shouldContain "nothing listens at elsewhere:none"
        }
    }
    test("commands that speak only Javino refuse it, with those that do not") {
        argo("request", "elsewhere:robot", "getPercepts").let {
            it.status shouldBe 2
            it.err shouldContain "elsewhere:robot is on no line, and this command speaks only Javino; monitor, send"
        }
        argo("monitor", "elsewhere:robot", "--raw").status shouldBe 2
    }
})
