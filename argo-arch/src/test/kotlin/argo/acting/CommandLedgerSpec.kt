package argo.acting

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

/** The port of a board with sensors, which has the ledger, and the port of a board with wheels. */
private enum class Ports { SENSORS, WHEELS }

class CommandLedgerSpec : FunSpec({
    var nowMs = 0L

    fun ledger() = CommandLedger({ nowMs }, { true }) { Ports.SENSORS }

    beforeTest { nowMs = 0 }

    test("commands to another board count while they go out, however slowly") {
        val ledger = ledger()
        val commands = List(5) { ledger.issue(Ports.WHEELS) }
        for (command in commands) {
            ledger.allDoneUpTo(commands.last()) shouldBe false
            nowMs += 90
            ledger.dueInMs(commands.last()) shouldBe 10
            ledger.done(Ports.WHEELS, command)
        }
        ledger.allDoneUpTo(commands.last()) shouldBe true
    }

    test("commands to another board do not count when none has gone there for 100 ms") {
        val ledger = ledger()
        val first = ledger.issue(Ports.WHEELS)
        val second = ledger.issue(Ports.WHEELS)
        nowMs = 60
        ledger.done(Ports.WHEELS, first)
        nowMs = 159
        ledger.allDoneUpTo(second) shouldBe false
        nowMs = 160
        ledger.allDoneUpTo(second) shouldBe true
    }

    test("what once went to another board is nothing to wait for later") {
        val ledger = ledger()
        ledger.done(Ports.WHEELS, ledger.issue(Ports.WHEELS))
        nowMs = 50
        val next = ledger.issue(Ports.WHEELS)
        ledger.dueInMs(next) shouldBe CommandLedger.ELSEWHERE_MS
    }
})
