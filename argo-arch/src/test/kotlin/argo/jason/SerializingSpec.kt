package argo.jason

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.string.shouldContain
import javino.sim.FakeBoard

class SerializingSpec : FunSpec({
    test("an agent goes on from its serialized form, with a new architecture, and without the ports and percepts that it had") {
        FakeBoard.plugIn("one").lenient().use { one ->
            FakeBoard.plugIn("two").lenient().use { two ->
                one.whenAsked("getPercepts").answer("dist(f,30);")
                LocalMas().use { mas ->
                    mas.agent("bob", """
                        !start.
                        +!start <- +met(wall); argo.port("sim:one", [boot(0)]); argo.percepts(open).
                        +!go <- argo.port("sim:two", [boot(0)]); argo.act(alive); +gone.
                    """)
                    mas.awaitBelief("bob", "dist(f,30)")
                    mas.serialize("bob", "copy")
                    mas.awaitBelief("copy", "met(wall)")
                    eventually(LIMIT) { mas.beliefs("copy") shouldNotContain "dist(f,30)" }
                    mas.achieve("copy", "go")
                    eventually(LIMIT) { two.received() shouldContain "alive" }
                    mas.beliefs("bob") shouldContain "dist(f,30)"
                    mas.log shouldContain "the agent goes on from its serialized form: it has no ports and no filter"
                }
            }
        }
    }
})
