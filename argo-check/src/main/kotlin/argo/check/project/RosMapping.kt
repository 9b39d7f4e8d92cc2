package argo.check.project

import javino.PerceptArgument
import javino.PerceptKind
import javino.PerceptTerm

/**
 * The percepts and commands of a ROS mapping (`.ros.yaml`). [isComplete] is false if a topic uses the default percepts of its type, which
 * are not known here.
 */
internal class RosMapping(text: String) {
    val isComplete: Boolean
    val percepts: List<PerceptKind>
    val actions: List<BoardAction>

    init {
        val sections = HashMap<String, MutableList<String>>()
        var section = ""
        for (line in text.lines().map { it.substringBefore(" #").trimEnd() }) {
            if (line.endsWith(":") && !line.startsWith(" ")) section = line.dropLast(1)
            ITEM.matchEntire(line)?.let { sections.getOrPut(section, ::ArrayList) += it.groupValues[1] }
        }
        val topics = sections["percepts"].orEmpty()
        isComplete = topics.all { ARROW in it }
        val feedback = sections["commands"].orEmpty().filter { FEEDBACK in it }.map { it.substringAfter(FEEDBACK) }
        val literals = topics.filter { ARROW in it }.map { it.substringAfter(ARROW) } + feedback
        percepts = literals.mapNotNull(::headOf).map { (name, arity) -> PerceptKind(name, List(arity) { PerceptArgument.Anything() }) }
        actions = sections["commands"].orEmpty().mapNotNull { headOf(it.substringBefore(ARROW)) }
            .map { (name, arity) -> BoardAction(name, arity) }
    }

    private fun headOf(text: String): Pair<String, Int>? {
        val name = NAME.find(text.trim())?.value ?: return null
        val rest = text.trim().removePrefix(name)
        return name to if (rest.startsWith("(")) PerceptTerm.of(rest).arguments().size else 0
    }

    private companion object {
        const val ARROW = " -> "
        const val FEEDBACK = " feedback "
        val ITEM = Regex("\\s*- +(.+)")
        val NAME = Regex("^[a-z]\\w*")
    }
}
