package argo.connecting

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import jason.asSyntax.ASSyntax
import javino.interleavings.concurrently
import javino.interleavings.inEachInterleaving

@Tags("Thorough")
class PortStatesInterleavingsSpec : FunSpec({
    val port = ASSyntax.createAtom("p")

    test("a change is believed or remains news") {
        inEachInterleaving {
            val states = PortStates { _, _, _ -> }
            var believed = false
            concurrently({ states.set(port, PortStatus.ON) }, { if (states.hasNews()) believed = states.beliefs().isNotEmpty() })
            check(believed || states.hasNews()) { "the state is neither believed nor news" }
        }
    }

    test("a port that is given up while it is reported is forgotten") {
        inEachInterleaving {
            val held = Holding()
            val states = PortStates { _, _, _ -> }
            concurrently(
                { states.set(port, PortStatus.TIMEOUT) { held.isHeld } },
                {
                    held.isHeld = false
                    states.clear()
                },
            )
            check(states.all().isEmpty()) { "the port is remembered: ${states.all()}" }
        }
    }
})

private class Holding {
    @Volatile
    var isHeld = true
}
