package argo.check.measuring

import argo.check.ProjectCheck
import argo.check.findings.Finding
import argo.check.findings.Level
import argo.check.project.AgentProgram
import argo.check.project.Project
import argo.check.project.ProjectReader
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.shouldBeGreaterThanOrEqual
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.ints.shouldBeGreaterThanOrEqual
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.writeText
import kotlin.random.Random

/**
 * Measures how many planted errors in real programs are found, and how many findings the unchanged programs have. `-Dargo.corpus=FOLDER`
 * names a folder with these programs. The programs are not part of this project.
 */
@Tags("Thorough")
class PlantedFaultsSpec : FunSpec({
    test("slips are found in their lines, and unchanged programs have few findings").config(enabled = CORPUS != null) {
        val projects = Path.of(CORPUS!!).listDirectoryEntries().sorted().flatMap { ProjectReader().projectsIn(it) }
        val programs = projects.flatMap { project -> project.programs.values.filter { isWhole(it) }.map { project to it } }
            .distinctBy { it.second.program.text }
        val unchanged = programs.groupBy({ it.first }, { it.second }).flatMap { (project, all) ->
            val check = ProjectCheck(project)
            all.map { it to check.findingsIn(it) }
        }.toMap()
        val planting = Planting(Random(SEED))
        val faults = generateSequence { programs[planting.next(programs.size)] }
            .mapNotNull { (project, program) -> planting.faultIn(program)?.let { project to it } }
            .filter { (_, fault) -> AgentProgram(fault.program.path, fault.planted).program.errors.isEmpty() }.take(FAULTS).toList()
        val found = faults.map { (project, fault) -> fault to levelOf(project, fault, unchanged.getValue(fault.program)) }

        val lines = programs.sumOf { it.second.program.lines.count }
        val findings = unchanged.values.flatten()
        val alarms = findings.filter { it.level != Level.HINT }
        val share = found.count { it.second != null } * 100.0 / found.size
        val rate = alarms.size * 1000.0 / lines
        val report = Path.of("target", "planted").createDirectories()
        val missed = faults.zip(found).filter { it.second.second == null }.map { it.first }
        val single = missed.filter { (project, fault) -> isNamedOnce(project, fault) }.toSet()
        report.resolve("missed.txt").writeText(
            missed.joinToString("\n") { each ->
                val (_, fault) = each
                "${fault.kind}: ${fault.program.path}:${fault.line} ${fault.description}${if (each in single) " (named once)" else ""}"
            },
        )
        report.resolve("findings.txt").writeText(findings.joinToString("\n", transform = ::line))
        val planted = faults.map { it.second.program }.distinct().size
        println("${programs.size} programs of ${projects.size} projects, $lines lines; ${found.size} faults in $planted programs")
        found.groupBy { it.first.kind }.toSortedMap().forEach { (kind, all) ->
            println("  $kind: ${all.count { it.second != null }} of ${all.size} found")
        }
        val graver = found.count { it.second == Level.ERROR || it.second == Level.WARNING }
        println("  all: %.1f %% found in the right line, $graver of them by an error or a warning".format(share))
        println("  ${missed.size} missed, of which ${single.size} are names that their project has once")
        println("unchanged: ${alarms.size} errors and warnings, %.2f in 1,000 lines; ${findings.size - alarms.size} hints".format(rate))
        findings.groupingBy { "${it.level} ${it.rule}" }.eachCount().toSortedMap().forEach { (rule, count) -> println("  $rule: $count") }

        planted shouldBeGreaterThanOrEqual 50
        share shouldBeGreaterThanOrEqual LEAST_SHARE
        rate shouldBeLessThanOrEqual GREATEST_RATE
    }
})

private val CORPUS: String? = System.getProperty("argo.corpus")

/** Limits for the test. The results in `docs/check.md` are better. */
private const val LEAST_SHARE = 91.0
private const val GREATEST_RATE = 2.0
private const val SEED = 30L
private const val FAULTS = 500
private const val MIN_LINES = 5

private fun line(finding: Finding) = "${finding.level} ${finding.rule} ${finding.place}: ${finding.what}; ${finding.remedy}"

private fun isWhole(program: AgentProgram) = program.program.errors.isEmpty() && program.program.lines.count >= MIN_LINES

private fun isNamedOnce(project: Project, fault: Fault): Boolean = fault.kind != Planting.SWAP && fault.written !in project.foreignNames &&
    project.programs.values.sumOf { program -> program.program.tokens.count { it.text == fault.written } } == 1

private fun levelOf(project: Project, fault: Fault, before: List<Finding>): Level? {
    val planted = project.with(fault.program.path, fault.planted)
    val after = ProjectCheck(planted).findingsIn(planted.programs.getValue(fault.program.path))
    val old = before.map { Triple(it.rule, it.place.begin.line, it.what) }.toSet()
    val new = after.filter { it.place.begin.line == fault.line && Triple(it.rule, it.place.begin.line, it.what) !in old }
    return new.minOfOrNull { it.level }
}
