package argo.recording

import argo.exploring.Exploration
import argo.exploring.RandomEvents
import argo.exploring.runOf
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds

/**
 * A system of agents with random drives: sensors change, messages arrive, and boards, cables and lines fail.
 *
 * @property source the file of the system
 * @property agents the names of the agents
 * @property boards the boards, with the percepts of their sensors
 */
internal class SeededDrives(val source: String, val agents: List<String>, private val boards: Exploration.() -> Unit) {
    fun record(seed: Long, file: Path) {
        val drawn = Exploration().apply(::describe)
        runOf(source, RandomEvents(drawn, agents).events(seed)) {
            describe(this)
            agents { options("argo_record" to "$file") }
        }
    }

    private fun describe(exploration: Exploration) {
        exploration.boards()
        exploration.eventful = 6.seconds
        exploration.settling = 3.seconds
    }

    override fun toString() = source.substringAfterLast('/')

    companion object {
        private const val SAMPLES = "../samples"

        private val robot: Exploration.() -> Unit = {
            board("sim:robot") {
                sensor("dist(f,%d)", 5..300)
                sensor("dist(b,%d)", 5..300)
                sensor("light(f,%d)", 0..200)
                sensor("temp(f,%d)", 10..40)
            }
        }

        val ALL: List<SeededDrives> = listOf(
            SeededDrives("../experiment/agent/experiment.mas2j", listOf("robot"), robot),
            SeededDrives("$SAMPLES/collision/collision.mas2j", listOf("robot")) {
                robot()
                message("robot", "boss", "achieve", "halt")
            },
            SeededDrives("$SAMPLES/delegation/delegation.mas2j", listOf("body", "pilot", "lamplighter"), robot),
            SeededDrives("$SAMPLES/typed-filters/typed-filters.mas2j", listOf("watcher"), robot),
            SeededDrives("$SAMPLES/blink/blink.mas2j", listOf("blink")) { board("sim:blink") },
            SeededDrives("$SAMPLES/turtle/turtle.mas2j", listOf("turtle")) {
                board("ros://127.0.0.1:9090#turtle") {
                    sensor("pose(%d,5,1)", 0..11)
                    sensor("other(9,%d)", 0..11)
                }
            },
            SeededDrives("$SAMPLES/two-boards/two-boards.mas2j", listOf("operator")) {
                board("sim:left") { sensor("led(left,off)", "led(left,on)") }
                board("sim:right") { sensor("led(right,off)", "led(right,on)") }
            },
            SeededDrives("$SAMPLES/three-boards/three-boards.mas2j", listOf("carrier")) {
                board("sim:wheels") {
                    knows("forward", "backward", "halt")
                    sensor("way(%d)", 0..90)
                    sensor("moving(no)", "moving(forward)", "moving(backward)")
                }
                board("sim:sensors") { sensor("dist(front,%d)", 5..200) }
                board("sim:arm") {
                    knows("grip", "release")
                    sensor("hand(open)", "hand(full)", "hand(closed)")
                }
            },
            SeededDrives("$SAMPLES/fleet/fleet.mas2j", listOf("coordinator", "scout1", "scout2")) {
                board("sim:rover") { sensor("at(north)", "at(east)", "at(south)", "at(west)") }
            },
        )
    }
}
