package argo.fleet

import argo.fleet.cluster.Overloaded
import argo.fleet.node.Claim
import argo.fleet.node.FleetMessage
import argo.fleet.node.Grant
import argo.fleet.node.MindNews
import argo.fleet.node.RosterNews
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.delay
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.atomic.AtomicBoolean
import kotlin.time.Duration.Companion.seconds

/** An agent that outlives its computer, on one of three computers, whose others are played here in real time. */
@Tags("Thorough")
class LeasesSpec : FunSpec({
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
            eventually(20.seconds) { // it grants nothing at the beginning
                base.cluster.receives("scout1", Claim("m", 1, 2))
                sent shouldContain Grant("m", 1, 2, true)
            }
            sent[sent.indexOf(Grant("m", 1, 2, true)) - 1] shouldBe mind
            sent.clear()
            base.cluster.receives("scout1", Claim("m", 2, 2, mindTerm = 1, mindNumber = 7))
            sent shouldBe listOf(Grant("m", 2, 2, true))
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
            eventually(20.seconds) { base.believed("m") shouldBe emptyList() }
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
            eventually(20.seconds) { isAble.get() shouldBe false }
            val claims = CopyOnWriteArrayList<FleetMessage>()
            base.cluster.answer = { one ->
                one.end.complete(null)
                claims += one.message
            }
            delay(1.seconds) // three claims would have been made
            claims shouldBe emptyList()
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
            eventually(20.seconds) { minds.size shouldBe 4 }
            base.shouldLog("has not got what m believes, and is told again: too much waits")
        }
    }
})
