package argo.orders

import argo.boundary.Overlaps
import argo.insides.IncludeDirective
import argo.insides.Insides
import argo.observing.ProgramFile
import argo.platform.Plans
import jason.asSemantics.Agent
import jason.asSyntax.Literal
import jason.asSyntax.Plan
import jason.asSyntax.directives.NameSpace
import java.io.IOException
import java.nio.charset.Charset
import java.nio.file.Path
import java.util.Collections
import java.util.IdentityHashMap

/**
 * A program that Jason has read, and its parts. No agent runs this program.
 *
 * @property files the program, followed by each file that it includes, in the order of their reading
 * @property paths the paths of the [files] that are on this computer's disks
 * @param draft the agent that has read the program
 */
internal class ProgramText private constructor(
    val files: List<ProgramFile>,
    val paths: List<Path>,
    draft: Agent,
    private val parts: List<Part>,
) {
    /** A [part] of [file], with its [plans]. [isOther] is true if the part contains more than plans, such as a rule, or changes Jason. */
    private class Part(val file: ProgramFile, val part: ProgramPart, val plans: List<Plan>, val isOther: Boolean)

    val plans: List<Plan> = Plans.of(draft).all.toList()

    /** The initial beliefs, without rules. */
    val beliefs: List<Literal> = draft.initialBels.filterNot(::isRule).map { it.capply(null) as Literal }

    val goals: List<Literal> = draft.initialGoals.toList()

    val addresses: Set<String> get() = files.mapTo(LinkedHashSet()) { it.address }

    /** The [files] with blanks in place of some parts. [without] are the plans of these parts. */
    class Shortened(val files: List<ProgramFile>, val without: Set<Plan>)

    /** Leaves out beliefs and goals. Also leaves out each part of the program whose plans are all in [kept]. */
    fun without(kept: Set<Plan>): Shortened {
        val once = files.groupBy { it.within to it.name }.values.mapNotNull { it.singleOrNull() }
        val dropped = parts.filter { !it.isOther && it.plans.all(kept::contains) && once.any { file -> file === it.file } }
        val without: MutableSet<Plan> = Collections.newSetFromMap(IdentityHashMap())
        dropped.forEach { without += it.plans }
        val shortened = files.map { file -> file.copy(text = file.text.without(dropped.filter { it.file === file }.map { it.part })) }
        return Shortened(shortened, without)
    }

    /** Lets a new agent read a program, and notes the parts of the program's files. */
    private class Drafting(private val find: (within: String, name: String) -> ProgramFile) {
        private val draft = Agent().apply { initAg() }
        private val parts = ArrayList<Part>()

        fun read(main: ProgramFile): Pair<Agent, List<Part>> = try {
            ProgramReading(draft, find, ::note).read(main)
            draft to parts
        } catch (broken: RuntimeException) { // such as a directive that does not exist
            throw OrderRefusedException("${main.shortName}: Jason cannot read it: $broken")
        } finally {
            draft.stopAg() // hides the agent from Jason's inspector
        }

        private fun note(file: ProgramFile, agent: Agent, read: () -> ProgramPart) {
            val (plans, beliefs, goals) = listOf(Plans.of(agent).all.size, agent.initialBels.size, agent.initialGoals.size)
            val part = read()
            val own = Plans.of(agent).all.drop(plans)
            val added = agent.initialBels.drop(beliefs)
            val isNothing = own.isEmpty() && added.isEmpty() && agent.initialGoals.size == goals // such as a registered function
            parts += Part(file, part, own, isNothing || added.any(::isRule))
        }
    }

    companion object {
        /**
         * Reads the program at [address], an agent's `aslSrc`, and all files that it includes. Searches for them where Jason does. Any
         * thread.
         *
         * @param looksAt called with each path, on this computer's disks, at which a file is read or an included file is missing
         * @throws OrderRefusedException if a file is missing, or if its content cannot be read or exchanged
         */
        fun read(address: String, looksAt: (Path) -> Unit): ProgramText {
            val sources = ArrayList<ProgramSource>()
            val files = ArrayList<ProgramFile>()
            fun add(within: String, name: String, called: String, source: ProgramSource) = ProgramFile(
                within, name, called, String(source.bytes, Charset.defaultCharset()), // as Jason reads programs
            ).also {
                sources += source
                source.path?.let(looksAt)
                files += it
            }
            val main = add("", "", ProgramSource.nameOf(address), mainAt(address))
            val number = Overlaps.begin()
            val (draft, parts) = try {
                Drafting { within, name -> included(within, name, looksAt).let { add(within, name, it.address, it) } }.read(main)
            } finally {
                Overlaps.end(number)
            }
            return ProgramText(files, sources.mapNotNull { it.path }, draft, parts).also { refuseLocalNames(it) }
        }

        /** Reads the program in [files] again. Finally restores Jason's counters, so no other agent may run during the call. */
        fun of(files: List<ProgramFile>): ProgramText {
            val counters = listOf(Insides.variableCounter, Insides.planCounter).map { it[null] }
            val before = counters.map { it.get() }
            val included = files.drop(1).iterator() // in the order of their reading
            try {
                val (draft, parts) = Drafting { _, _ -> included.next() }.read(files.first())
                return ProgramText(files, emptyList(), draft, parts)
            } finally {
                counters.zip(before) { counter, value -> counter.set(value) }
            }
        }

        private fun isRule(belief: Literal) = belief.isRule || !belief.isGround

        private fun mainAt(address: String) = try {
            ProgramSource.at(address)
        } catch (missing: IOException) {
            throw OrderRefusedException("the program cannot be read: $missing")
        }

        private fun included(within: String, name: String, looksAt: (Path) -> Unit): ProgramSource {
            val outer = within.ifEmpty { null }
            ProgramSource.included(name, outer, IncludeDirective.sourcePath)?.let { return it }
            ProgramSource.placesOf(name, outer, IncludeDirective.sourcePath).forEach(looksAt)
            throw OrderRefusedException("the included file $name is not found")
        }

        private fun refuseLocalNames(program: ProgramText) {
            val literals = program.plans.map { it.trigger.literal } + program.beliefs + program.goals
            val local = literals.find { it.ns.functor.startsWith(NameSpace.LOCAL_PREFIX) } ?: return
            throw OrderRefusedException(
                "${local.ns} is a local namespace, which Jason names anew at each reading; make it global to reload the program",
            )
        }
    }
}
