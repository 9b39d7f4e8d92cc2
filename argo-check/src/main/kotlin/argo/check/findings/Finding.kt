package argo.check.findings

import argo.check.syntax.Position
import java.nio.file.Path

/** How sure and how grave a finding is. */
enum class Level {
    /** Jason refuses the program, or this fails whenever it runs. */
    ERROR,

    /** This is very probably not meant. */
    WARNING,

    /** This may be meant, and is worth a look. */
    HINT,
}

/** A part of [file] from [begin] up to [end], which it does not contain. */
data class Place(val file: Path, val begin: Position, val end: Position) {
    override fun toString(): String = "$file:$begin"
}

/**
 * A finding of a check.
 *
 * @property rule the rule's name, as `goal-without-plan`
 * @property what what is found, in a sentence without a full stop
 * @property why the consequence
 * @property remedy what to do
 */
data class Finding(val rule: String, val level: Level, val place: Place, val what: String, val why: String, val remedy: String)
