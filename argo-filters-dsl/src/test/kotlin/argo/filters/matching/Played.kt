package argo.filters.matching

import argo.filters.PerceptionFilter

/** A session that keeps its last perception for the test. */
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
