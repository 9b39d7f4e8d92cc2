package argo.debug

import argo.recording.replay.Recording
import argo.recording.replay.RecordingException
import argo.recording.replay.Replay
import argo.testkit.agent
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import org.eclipse.lsp4j.debug.ContinueArguments
import org.eclipse.lsp4j.debug.NextArguments
import java.net.InetAddress
import java.net.ServerSocket
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import kotlin.io.path.writeText

class ReplayDebugSpec : FunSpec({
    val folder = tempdir().toPath().toRealPath()
    val file = folder.resolve("bob.asl").apply { writeText(PROGRAM) }
    val drive = folder.resolve("drive.mcap")
    agent(file) { options("argo_record" to "$drive") }.use { bob ->
        for (cm in listOf(90, 60, 38)) bob.perceives("dist(f,$cm)").shouldSend("slow($cm)")
    }

    test("a debugger stops the replay of a recorded agent, reads what it knew there, and takes steps; the replay is identical") {
        val port = freePort()
        Recording(drive).use { recording ->
            Replay(recording, debugPort = port).use { replay ->
                replay.pause() shouldBe "bob"
                val debugging = CompletableFuture.runAsync {
                    Debugger(port).use {
                        it.breakAt("$file", 4) shouldBe listOf("4")
                        it.configured()
                        val first = it.stop()
                        (first.reason to first.text) shouldBe ("pause" to "the world stands still with it")
                        for (cm in listOf(90, 60, 38)) {
                            it.server.continue_(ContinueArguments().apply { threadId = 1 }).value()
                            it.stop().reason shouldBe "breakpoint"
                            val frame = it.frames(1).first()
                            "${frame.name} at ${frame.source.path}:${frame.line}" shouldBe "+dist(f,$cm) at $file:4"
                            it.read(frame, "Variables") shouldBe listOf("X = $cm")
                            it.read(frame, "Beliefs") shouldContain "dist(f,$cm) = [source(percept)]"
                            it.evaluate("dist(f,D) & far(L) & D < L", frame) shouldBe if (cm < 40) "D = 38, L = 40" else "false"
                            it.server.next(NextArguments().apply { threadId = 1 }).value()
                            it.stop().reason shouldBe "step"
                            it.frames(1).first().line shouldBe 5
                        }
                        it.disconnect()
                    }
                }
                val running = CompletableFuture.runAsync { replay.run() }
                CompletableFuture.allOf(debugging, running).get(1, TimeUnit.MINUTES)
                replay.differences.shouldBeEmpty()
                replay.cyclesRun shouldBe recording.cycles("bob").count().toLong()
            }
        }
    }

    test("a replay that no debugger can reach is refused") {
        ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { taken ->
            Recording(drive).use {
                shouldThrow<RecordingException> { Replay(it, debugPort = taken.localPort) }.message shouldBe
                    "no debugger can reach agent bob at port ${taken.localPort}; the log says why"
            }
        }
    }
})

private const val PROGRAM = """far(40). !start.
+!start <- argo.port(ttyACM0); argo.limit(20); argo.percepts(open).
+dist(f,X)
   <- +seen(X);
      argo.act(slow(X)).
"""
