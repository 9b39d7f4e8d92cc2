package argo.lsp.project

import argo.check.project.AgentProgram
import argo.check.syntax.Program
import argo.lsp.text.Text
import java.nio.file.Path

internal class Source(val agent: AgentProgram, val text: Text) {
    val file: Path get() = agent.path
    val program: Program get() = agent.program
    val occurrences: List<Occurrence> by lazy { agent.mentions.all.mapNotNull(Occurrence::of) }

    fun occurrenceAt(offset: Int): Occurrence? = occurrences.find { it.name.touches(offset) }
}
