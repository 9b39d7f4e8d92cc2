package benchmarks.fleet

import benchmarks.figures
import benchmarks.residentMb
import java.io.File
import kotlin.io.path.writeText

private const val COMPUTERS = 50
private const val AGENTS = 20
private const val MAX_START_S = 60
private const val MAX_SHARE = 0.1
private const val PATIENCE_S = 300
private const val IDLE_S = 30

private const val FEW = "few.mas2j"
private const val ENDS = "ends"
private const val JASON = "jason.infra.local.RunLocalMAS"

/** The time between the starts of two processes. Two processors start about two processes per second. */
internal const val PACE_MS = 500L

/**
 * Measures the time until fifty computers know a thousand agents, and the cost of these computers. Measures also the cost of as many agents
 * in processes of Jason without a fleet.
 */
internal fun crowd(): Boolean {
    val names = List(COMPUTERS) { "computer${it + 1}" }
    val agents = names.joinToString(" ") { "watcher_$it watcher.asl at \"$it\"; member_${it}_ member.asl #${AGENTS - 1} at \"$it\";" }
    val mas2j = "MAS bench { infrastructure: ${Project.fleetOf(names)} agents: $agents }"
    val reached = Project(mas2j, listOf("watcher", "member")).use { project ->
        val few = listOf("archiving", "second", "third")
        val members = few.joinToString(" ") { "$it ${if (it == few[0]) ENDS else "member"}.asl at \"$it\";" }
        val fleet = "MAS few { infrastructure: ${Project.fleetOf(few)} agents: $members }"
        val options = sharing(project, fleet, few.size, few.map { Project.computer(it, FEW) })
        val begin = System.nanoTime()
        val processes = startAll(project, options, names.map { Project.computer(it) })
        val seconds = (System.nanoTime() - begin) / 1e9
        val cost = costOf(processes)
        val residentMb = processes.sumOf { residentMb("VmRSS", "${it.pid()}") }
        val isEqual = project.noted(NAMES).map { it[1] }.distinct().size == 1
        println(
            figures("%d processes with %,d agents: all know all after %.0f s", COMPUTERS, COMPUTERS * AGENTS, seconds) +
                ", $cost, .all_names ${if (isEqual) "equal" else "differ"}" + figures(", %,.0f MB", residentMb),
        )
        isEqual && seconds <= MAX_START_S && cost.share <= MAX_SHARE
    }
    println("as many agents in processes of Jason without a fleet: ${withoutFleet()}")
    return reached
}

private fun withoutFleet(): Cost {
    val agents = "counted; member member.asl #${AGENTS - 1};"
    return Project("MAS bench { infrastructure: Local agents: $agents }", listOf("counted", "member")).use { project ->
        val options = sharing(project, "MAS few { infrastructure: Local agents: $ENDS; }", 1, listOf(listOf(JASON, FEW)))
        costOf(startAll(project, options, List(COMPUTERS) { listOf(JASON, Project.MAS2J) }))
    }
}

/** Starts [programs] one after the other. Returns their processes after an agent in each has counted all agents. */
private fun startAll(project: Project, options: List<String>, programs: List<List<String>>): List<Process> {
    val processes = programs.map { program -> project.start(program, options).also { Thread.sleep(PACE_MS) } }
    project.await(PATIENCE_S, "that an agent in each process knows all agents") { project.noted(NAMES).size == programs.size }
    return processes
}

/**
 * The cost of processes.
 *
 * @property start the processor time for their start, in seconds
 * @property share the share of one processor that they use later, when nothing happens
 */
private class Cost(val start: Double, val share: Double) {
    override fun toString() = figures("%.0f s of processor time, idle %.1f %% of a processor", start, share * 100)
}

private fun costOf(processes: List<Process>): Cost {
    fun seconds() = processes.sumOf(::ticks) / TICKS_A_SECOND
    val start = seconds()
    Thread.sleep(IDLE_S * 1000L)
    val before = seconds()
    Thread.sleep(IDLE_S * 1000L)
    return Cost(start, (seconds() - before) / IDLE_S)
}

/**
 * Makes an archive of the classes that the first of [programs] loads until it knows [agents] agents. Returns Java options that share the
 * archive, save memory and compile quickly. Many processes then fit on one computer.
 *
 * @param few the text of the programs' project, [FEW]. The first program has the agent [ENDS]
 */
private fun sharing(project: Project, few: String, agents: Int, programs: List<List<String>>): List<String> {
    val small = listOf("-Xmx64m", "-Xss512k", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-XX:-UsePerfData")
    project.packClasses()
    project.file(FEW).writeText(few)
    project.file("$ENDS.asl").writeText("!end. +!end : .all_names(L) & .length(L, $agents) <- .stopMAS(0). +!end <- .wait(100); !end.")
    val archive = project.file("classes.jsa")
    val processes = programs.mapIndexed { place, program ->
        project.start(program, if (place == 0) small + "-XX:ArchiveClassesAtExit=$archive" else small)
    }
    check(processes.all { it.waitFor() == 0 }) { project.printed() }
    return small + "-XX:SharedArchiveFile=$archive"
}

private fun ticks(process: Process): Long =
    File("/proc/${process.pid()}/stat").readText().substringAfterLast(") ").split(' ').let { it[UTIME].toLong() + it[UTIME + 1].toLong() }

private const val TICKS_A_SECOND = 100.0

/** The index of the user time in `/proc/PID/stat`, counted from 0 behind the program's name. */
private const val UTIME = 11
