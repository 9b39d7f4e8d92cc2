package argo.check.findings

import argo.check.syntax.Position
import java.nio.file.Path

/** The severity of a finding. */
enum class Level {
    /** Jason refuses the program, or this step always fails. */
    ERROR,

    /** The author very probably made a mistake. */
    WARNING,

    /** The code may be intended, but the author should check it. */
    HINT,
}

/** The part of [file] from [begin] up to [end]. The character at [end] is outside. */
data class Place(val file: Path, val begin: Position, val end: Position) {
    override fun toString(): String = "$file:$begin"
}

/**
 * A finding of a check.
 *
 * @property rule the rule's name, such as `goal-without-plan`
 * @property what the finding, a sentence without a full stop
 * @property why the consequence of the finding
 * @property remedy advice for the author
 */
data class Finding(val rule: String, val level: Level, val place: Place, val what: String, val why: String, val remedy: String)
