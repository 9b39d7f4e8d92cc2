package argo

import jason.asSyntax.Literal

/**
 * What the sensors said in one message.
 *
 * @property texts the percepts as they came off the line
 * @property filter the filter that was active when it came
 * @property percepts what [filter] lets through
 * @property receivedNanos when its last byte came, by [System.nanoTime]
 */
internal class Snapshot(val texts: List<String>, val filter: ActiveFilter, val percepts: List<Literal>, val receivedNanos: Long)
