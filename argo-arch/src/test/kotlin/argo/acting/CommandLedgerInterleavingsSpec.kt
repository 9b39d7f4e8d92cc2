package argo.acting

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving

@Tags("Thorough")
class CommandLedgerInterleavingsSpec : FunSpec({
    test("a command that was issued while the port changed is awaited on its own port alone") {
        inEachInterleaving {
            val inUse = Holder("a")
            val ledger = CommandLedger { inUse.port }
            concurrently({ inUse.port = "b" }, { ledger.issue(inUse.port) })
            val onB = ledger.allDoneUpTo(ledger.lastIssued())
            inUse.port = "a"
            val onA = ledger.allDoneUpTo(ledger.lastIssued())
            check(onA != onB) { "done on a: $onA, on b: $onB" }
        }
    }

    test("commands that end on other threads while new ones are issued are awaited no longer") {
        inEachInterleaving {
            val ledger = CommandLedger { "a" }
            val first = ledger.issue("a")
            concurrently({ ledger.done("a", first) }, { ledger.done("a", ledger.issue("a")) })
            check(ledger.lastIssued() == 2L && ledger.allDoneUpTo(2)) { "a command that has ended is awaited" }
        }
    }
})

private class Holder(@Volatile var port: String)
