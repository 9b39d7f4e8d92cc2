package argo.check.project

import argo.check.findings.Place
import argo.check.syntax.Directive
import argo.check.syntax.Literal
import argo.check.syntax.Plan
import argo.check.syntax.Program
import argo.check.syntax.Span
import argo.check.syntax.StringTerm
import argo.check.syntax.Unread
import argo.check.syntax.programOf
import java.nio.file.Path

/** An AgentSpeak file. */
class AgentProgram(val path: Path, text: String) {
    val program: Program = programOf(text)

    val mentions: Mentions by lazy { MentionReader().read(program.components) }

    /** The words in text that the reader skipped after an error. The roles of these words are unknown. */
    val unread: Set<String> by lazy {
        val spans = program.components.filterIsInstance<Unread>().map { it.span }
        val tokens = if (spans.isEmpty()) emptyList() else program.tokens.filter { token -> spans.any { it.touches(token.span.start) } }
        tokens.map { it.text }.toSet()
    }

    /** The paths of included files, as written in the program. */
    val includes: List<String> get() = directives("include").mapNotNull { (it.call?.arguments?.firstOrNull() as? StringTerm)?.text }

    internal val filtersCalled: List<String> by lazy {
        mentions[Role.INTERNAL].filter { it.functor.endsWith("change_filter") }.mapNotNull {
            when (val name = it.literal.arguments.firstOrNull()) {
                is Literal -> name.functor
                is StringTerm -> name.text.substringAfterLast('/')
                else -> null
            }
        }
    }

    /** True if a directive contains a program, as Jason's patterns do. The contained program may add plans. */
    val hasPatterns: Boolean get() = program.nodes().any { it is Directive && it.components != null && it.call?.functor != "namespace" }

    /**
     * The offsets of the goals of plans annotated `test`. Jason finds test plans by their labels. The goals of test plans may have any
     * name.
     */
    val goalsOfTests: Set<Int> by lazy {
        program.nodes().filterIsInstance<Plan>()
            .filter { plan -> plan.label?.annotations?.items.orEmpty().any { (it as? Literal)?.functor == "test" } }
            .mapNotNull { (it.trigger.term as? Literal)?.name?.span?.start }.toSet()
    }

    /** The goals and beliefs, with their arities, that comments list: `argo: others may send goal/2, belief/1`. */
    val sentByOthers: Set<String> by lazy {
        val lists = program.comments().mapNotNull { (_, text) -> OTHERS.find(text)?.groupValues?.get(1) }
        lists.flatMap { list -> WORD.findAll(list).map { it.value } }.toSet()
    }

    fun place(span: Span): Place = Place(path, program.lines.position(span.start), program.lines.position(span.end))

    private fun directives(name: String) = program.nodes().filterIsInstance<Directive>().filter { it.call?.functor == name }.toList()

    private companion object {
        val OTHERS = Regex("\\bargo: *others may send (.*)")
        val WORD = Regex("[a-z]\\w*(/\\d+)?")
    }
}
