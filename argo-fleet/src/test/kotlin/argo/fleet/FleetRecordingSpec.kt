package argo.fleet

import argo.fleet.cluster.Refused
import argo.fleet.cluster.Unreachable
import argo.fleet.node.Kill
import argo.fleet.node.RosterNews
import argo.fleet.node.Say
import argo.mcap.McapReader
import argo.recording.replay.Recording
import argo.recording.replay.Replay
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith
import kotlin.time.Duration.Companion.seconds

/** A replay of a recorded agent without its fleet repeats the agent's actions. */
class FleetRecordingSpec : FunSpec({
    val program = """
        +!go <- .send(b, tell, hello); +said; !ask; !lose; !miss; !late; !kill; .broadcast(tell, bye); .send(a, tell, own); +done.
        +!ask <- .send(b, askOne, p(X), A); +got(A).
        +!lose <- .send(b, tell, lost). -!lose[error(E)] <- +lost(E).
        +!miss <- .send(nobody, tell, x). -!miss[error(no_agent),error(receiver_not_found)] <- +missed.
        +!late <- .send(b, askOne, q(X), A). -!late[error(E)] <- +late(E).
        +!kill : not back <- .wait(10); !kill.
        +!kill <- .kill_agent(b). -!kill[error(E)] <- +spared(E).
    """.trimIndent()
    val told = listOf("said", "lost(unreachable)", "missed", "late(unreachable)", "spared(not_killed)", "done").map { "$it[source(self)]" }

    test("messages to other computers that arrive and that are lost, questions, refusals and broadcasts replay as they were") {
        val file = tempdir().toPath().resolve("drive.mcap")
        OneComputer("a [argo_record=\"$file\"] agentArchClass argo.Arch at \"base\";", "a" to program).use { base ->
            val cluster = base.cluster
            cluster.view("scout1" to "1")
            cluster.receives("scout1", RosterNews(isWhole = true, came = setOf("b")))
            cluster.receives("scout1", Say("mid1", null, "achieve", "b", "a", "go"))
            cluster.next().end.complete(null)
            base.shouldBelieve("a", "said[source(self)]")
            val asked = cluster.next()
            asked.end.complete(null)
            cluster.receives("scout1", Say("mid9", (asked.message as Say).id, "tell", "b", "a", "p(7)"))
            cluster.next().end.completeExceptionally(Unreachable("scout1 is off"))
            base.shouldBelieve("a", "missed[source(self)]")
            cluster.next().end.complete(null)
            cluster.view()
            cluster.view("scout1" to "1")
            cluster.receives("scout1", Say("mid10", null, "tell", "b", "a", "back"))
            val kill = cluster.next()
            kill.message shouldBe Kill("b", "a", 0)
            kill.end.completeExceptionally(Refused("not_killed", "b does not let a kill it"))
            cluster.next().end.complete(null)
            base.shouldBelieve("a", "done[source(self)]")
        }
        eventually(60.seconds) { McapReader(file).use { it.isComplete } shouldBe true }
        Recording(file).use { recording ->
            Replay(recording).use { replay ->
                replay.run()
                replay.differences.shouldBeEmpty()
                replay.refusals.shouldBeEmpty()
                replay.beliefs("a") shouldContainAll told
                replay.beliefs("a").single { it.startsWith("got(p(7)") } shouldEndWith ")[source(self)]"
            }
        }
    }
})
