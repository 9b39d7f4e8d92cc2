package argo.check.findings

import argo.check.syntax.Position
import java.nio.file.Path

/** How certain a finding is, and how serious. */
enum class Level {
    /** Jason refuses the program, or the step at this place always fails. */
    ERROR,

    /** The author very probably meant something else. */
    WARNING,

    /** The author may have meant this, but should check it. */
    HINT,
}

/** The part of [file] from [begin] up to [end], the first position behind the part. */
data class Place(val file: Path, val begin: Position, val end: Position) {
    override fun toString(): String = "$file:$begin"
}

/**
 * A finding of a check.
 *
 * @property rule the rule's name, such as `goal-without-plan`
 * @property what the finding, in a sentence without a full stop
 * @property why the consequence
 * @property remedy what to do
 */
data class Finding(val rule: String, val level: Level, val place: Place, val what: String, val why: String, val remedy: String)
