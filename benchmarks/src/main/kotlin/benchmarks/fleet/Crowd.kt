package benchmarks.fleet

import benchmarks.figures
import java.io.File
import kotlin.io.path.writeText

private const val COMPUTERS = 50
private const val AGENTS = 20
private const val MAX_START_S = 60
private const val MAX_SHARE = 0.1
private const val PATIENCE_S = 300
private const val IDLE_S = 30

/** The time between the starts of two processes. Two processors start about two processes per second. */
internal const val PACE_MS = 500L

/** Measures the time until fifty computers know a thousand agents, and the cost of these computers when idle. */
internal fun crowd(): Boolean {
    val names = List(COMPUTERS) { "computer${it + 1}" }
    val agents = names.joinToString(" ") { "watcher_$it watcher.asl at \"$it\"; member_${it}_ member.asl #${AGENTS - 1} at \"$it\";" }
    return Project("MAS bench { infrastructure: ${Project.fleetOf(names)} agents: $agents }", listOf("watcher", "member")).use { project ->
        val options = sharing(project)
        val begin = System.nanoTime()
        val processes = names.map { name -> project.startComputer(name, options).also { Thread.sleep(PACE_MS) } }
        project.await(PATIENCE_S, "that all know ${COMPUTERS * AGENTS} agents") { project.noted(NAMES).size == COMPUTERS }
        val seconds = (System.nanoTime() - begin) / 1e9
        val isEqual = project.noted(NAMES).map { it[1] }.distinct().size == 1
        Thread.sleep(IDLE_S * 1000L)
        val before = processes.sumOf(::ticks)
        Thread.sleep(IDLE_S * 1000L)
        val share = (processes.sumOf(::ticks) - before) / TICKS_A_SECOND / IDLE_S
        println(
            figures("%d processes with %,d agents: all know all after %.0f s", COMPUTERS, COMPUTERS * AGENTS, seconds) +
                figures(", idle %.1f %% of a processor", share * 100) +
                figures(", .all_names %s, %,d MB", if (isEqual) "equal" else "differ", processes.sumOf(::residentKb) / 1024),
        )
        isEqual && seconds <= MAX_START_S && share <= MAX_SHARE
    }
}

/**
 * Makes an archive of the classes that a computer loads until it is in touch with others. Returns Java options that share the archive, save
 * memory and compile quickly. Many processes then fit on one computer.
 */
private fun sharing(project: Project): List<String> {
    val small = listOf("-Xmx64m", "-Xss512k", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-XX:-UsePerfData")
    project.packClasses()
    val names = listOf("archiving", "second", "third")
    val agents = names.joinToString(" ") { "$it ${if (it == names[0]) "ends" else "member"}.asl at \"$it\";" }
    project.file("few.mas2j").writeText("MAS few { infrastructure: ${Project.fleetOf(names)} agents: $agents }")
    project.file("ends.asl").writeText("!end. +!end : .all_names(L) & .length(L, ${names.size}) <- .stopMAS(0). +!end <- .wait(100); !end.")
    val archive = project.file("classes.jsa")
    val processes = names.map { name ->
        project.startComputer(name, if (name == names[0]) small + "-XX:ArchiveClassesAtExit=$archive" else small, "few.mas2j")
    }
    check(processes.all { it.waitFor() == 0 }) { project.printed() }
    return small + "-XX:SharedArchiveFile=$archive"
}

private fun ticks(process: Process): Long =
    File("/proc/${process.pid()}/stat").readText().substringAfterLast(") ").split(' ').let { it[UTIME].toLong() + it[UTIME + 1].toLong() }

private fun residentKb(process: Process): Long =
    File("/proc/${process.pid()}/status").readLines().first { it.startsWith("VmRSS") }.filter(Char::isDigit).toLong()

private const val TICKS_A_SECOND = 100.0

/** The index of the user time in `/proc/PID/stat`, counted from 0 behind the program's name. */
private const val UTIME = 11
