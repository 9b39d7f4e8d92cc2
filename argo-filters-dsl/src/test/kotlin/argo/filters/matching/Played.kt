package argo.filters.matching

import argo.filters.PerceptionFilter

/** A session that remembers its last perception, so that a test reads as the session was used. */
class Played<P : Any>(private val session: FilterSession<P>) {
    private lateinit var last: FilteredPercepts<P>

    val filter get() = session.filter
    val seen get() = last.seen
    val critical get() = last.critical
    val nextDueMs get() = last.nextDueMs

    fun switchTo(filter: PerceptionFilter?) = session.switchTo(filter)

    fun perceive(percepts: List<P>, nowMs: Long): List<P> = session.perceive(percepts, nowMs).also { last = it }.kept

    fun due(nowMs: Long): List<P>? = session.due(nowMs)?.also { last = it }?.kept

    fun explain(percept: P, nowMs: Long) = session.explain(percept, nowMs)
}
