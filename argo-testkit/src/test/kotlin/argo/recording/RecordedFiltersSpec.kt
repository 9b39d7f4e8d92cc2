package argo.recording

import argo.filters.format.XmlFilters
import argo.recording.replay.Recording
import argo.testkit.agent
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.time.Duration
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.milliseconds

/** A recording contains the agent's filters and the cycles in which they changed. */
class RecordedFiltersSpec : FunSpec({
    fun filter(predicate: String) = "<PerceptionFilter><filter><predicate>$predicate</predicate></filter></PerceptionFilter>"

    test("a filter of all boards, one of a board alone, and one that has changed meanwhile") {
        val file = recordingFile()
        val night = file.parent.resolve("filters").createDirectories().resolve("night.xml").apply { writeText(filter("light")) }
        val program = file.parent.resolve("robot.asl").apply {
            writeText(
                """
                !start.
                +!start <- argo.port(ttyACM0); argo.percepts(open); argo.change_filter(night); .wait(500);
                   argo.change_filter(night, [port(ttyACM0)]); argo.change_filter(none).
                """.trimIndent(),
            )
        }
        agent(program) { options("argo_record" to "$file") }.use {
            it.after(300.milliseconds)
            night.writeText(filter("temp"))
            it.after(500.milliseconds)
        }
        Recording(file).use { recording ->
            recording.cycles("robot").flatMap { it.input.filters }.toList() shouldBe listOf(
                FilterChange(null, "night", "filter/robot/night.xml"),
                FilterChange("ttyACM0", "night", "filter/robot/night-2.xml"),
                FilterChange(null, null, null),
            )
            fun stored(name: String) = XmlFilters.read(recording.program.getValue(name).decodeToString(), name)
            stored("filter/robot/night.xml") shouldBe XmlFilters.read(filter("light"), "night.xml")
            stored("filter/robot/night-2.xml") shouldBe XmlFilters.read(filter("temp"), "night.xml")
        }
    }

    test("a drive with smoothed percepts is replayed without a difference, as a whole and from a key frame on") {
        val file = recorded(
            """
            !start.
            +!start <- argo.change_filter(steady); argo.port(ttyACM0); argo.limit(500); argo.percepts(open).
            +dist(front,Cm)[smoothed] <- .print(Cm); argo.act(seen(Cm)).
            """.trimIndent(),
        ) {
            repeat(24) {
                perceives("dist(front,${if (it % 6 == 5) 300 else 60 - 2 * it})", "light(back,140)")
                after(500.milliseconds)
            }
        }
        Recording(file).use { recording ->
            val kept = recording.cycles("agent").flatMap { it.input.snapshots }.mapNotNull { it.kept }.toList()
            kept.last().first() shouldContain "[smoothed]"
        }
        shouldReplay(file)
        replayOf(ringOf(file, Duration.ofSeconds(10))).differences.shouldBeEmpty()
    }
})
