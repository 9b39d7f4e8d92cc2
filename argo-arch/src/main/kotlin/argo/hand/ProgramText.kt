package argo.hand

import argo.boundary.Overlaps
import argo.insides.KeptInclude
import argo.observing.ProgramFile
import argo.platform.Plans
import jason.asSemantics.Agent
import jason.asSyntax.Literal
import jason.asSyntax.directives.NameSpace
import java.io.File
import java.io.IOException
import java.net.MalformedURLException
import java.net.URL
import java.nio.charset.Charset
import java.nio.file.Path

/**
 * The text of a program on disk, which Jason can read.
 *
 * @property files the program, and behind it each file that it includes
 * @property paths the paths of those [files] that are on this computer's disks
 * @property beliefs its initial beliefs, without rules
 * @property goals its initial goals
 */
internal class ProgramText private constructor(
    val files: List<ProgramFile>,
    val paths: List<Path>,
    val beliefs: List<Literal>,
    val goals: List<Literal>,
) {
    val addresses: Set<String> get() = files.mapTo(LinkedHashSet()) { it.address }

    companion object {
        /**
         * Reads the program at [address], an agent's `aslSrc`, and all files that it includes, found as Jason finds them. Any thread.
         * @throws OrderRefusedException if a file is missing, or Jason cannot read it, or could not exchange it
         */
        fun read(address: String): ProgramText {
            val sources = ArrayList<ProgramSource>()
            val files = ArrayList<ProgramFile>()
            fun add(within: String, name: String, called: String, source: ProgramSource) = ProgramFile(
                within, name, called, String(source.bytes, Charset.defaultCharset()), // Jason reads programs so
            ).also {
                sources += source
                files += it
            }
            val main = add("", "", nameOf(address), mainAt(address))
            val draft = Agent().apply { initAg() } // it only reads
            val number = Overlaps.begin()
            try {
                ProgramReading(draft) { within, name -> included(within, name).let { add(within, name, it.address, it) } }.read(main)
            } catch (broken: RuntimeException) { // such as of a directive that there is not
                throw OrderRefusedException("${main.shortName}: Jason cannot read it: $broken")
            } finally {
                Overlaps.end(number)
                draft.stopAg() // so that Jason's inspector does not show it
            }
            refuseLocalNames(draft)
            val beliefs = draft.initialBels.filter { !it.isRule && it.isGround }.map { it.capply(null) as Literal }
            return ProgramText(files, sources.mapNotNull { it.path }, beliefs, draft.initialGoals.toList())
        }

        private fun mainAt(address: String) = try {
            ProgramSource.at(address)
        } catch (missing: IOException) {
            throw OrderRefusedException("the program cannot be read: $missing")
        }

        private fun included(within: String, name: String): ProgramSource =
            ProgramSource.included(name, within.ifEmpty { null }, KeptInclude.sourcePath)
                ?: throw OrderRefusedException("the included file $name is not found")

        /** Returns Jason's name of the program at [address]: its URL, or the name of its file. */
        fun nameOf(address: String): String = try {
            "${URL(address)}"
        } catch (_: MalformedURLException) {
            File(address).name
        }

        private fun refuseLocalNames(draft: Agent) {
            val literals = Plans.of(draft).all.map { it.trigger.literal } + draft.initialBels + draft.initialGoals
            val local = literals.find { it.ns.functor.startsWith(NameSpace.LOCAL_PREFIX) } ?: return
            throw OrderRefusedException(
                "${local.ns} is a local namespace, which Jason names anew at each reading; make it global to reload the program",
            )
        }
    }
}
