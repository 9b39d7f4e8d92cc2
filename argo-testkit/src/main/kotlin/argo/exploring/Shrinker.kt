package argo.exploring

import kotlin.math.roundToInt
import kotlin.math.roundToLong
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/**
 * Shortens and simplifies a list of events that breaks a rule (delta debugging). First removes halves, smaller parts and single events.
 * Then rounds the times and numbers of the remaining events. [breaks] runs events and returns true if they still break the rule.
 */
internal class Shrinker(private var budget: Int, private val breaks: (List<WorldEvent>) -> Boolean) {
    fun shrink(events: List<WorldEvent>): List<WorldEvent> {
        var left = withoutParts(events)
        while (budget > 0) {
            val plainer = withoutParts(plainer(left))
            if (plainer == left) break
            left = plainer
        }
        return left
    }

    private fun withoutParts(events: List<WorldEvent>): List<WorldEvent> {
        var left = events
        var size = left.size
        while (size > 0) {
            var from = 0
            while (from < left.size) {
                val fewer = left.subList(0, from) + left.drop(from + size)
                if (stillBreaks(fewer)) left = fewer else from += size
            }
            size /= 2
        }
        return left
    }

    private fun plainer(events: List<WorldEvent>): List<WorldEvent> {
        var left = events
        for (index in events.indices) {
            for (fieldIndex in left[index].form.fields.indices) {
                val (name, value) = left[index].form.fields[fieldIndex]
                val plainer = plainer(name, value).map { left.toMutableList().apply { set(index, get(index).form.with(fieldIndex, it)) } }
                left = plainer.firstOrNull(::stillBreaks) ?: left
            }
        }
        return left
    }

    /** Returns rounder or smaller values than [value], the best first. The start of an event is only rounded. */
    private fun plainer(name: String, value: Any): List<Any> = when (value) {
        is Duration -> {
            val ms = value.inWholeMilliseconds
            val rounded = STEPS_MS.map { step -> if (name == "at") (ms.toDouble() / step).roundToLong() * step else ms / step * step }
            (LENGTHS_MS.filter { name != "at" && it < ms } + rounded).filter { it > 0 && it != ms }.distinct().map { it.milliseconds }
        }
        is Int -> if (name == "oneIn") emptyList() else NUMBERS.filter { it < value }
        is String -> if (name == "percept" || name == "other") roundedNumber(value) else emptyList()
        else -> emptyList()
    }

    private fun roundedNumber(percept: String): List<String> {
        val number = NUMBER.find(percept) ?: return emptyList()
        val rounded = (number.value.toDouble() / TEN).roundToInt() * TEN
        return listOf(percept.replaceRange(number.range, "$rounded")).filter { it != percept && rounded > 0 }
    }

    private fun stillBreaks(events: List<WorldEvent>): Boolean = budget-- > 0 && breaks(events)

    private companion object {
        val STEPS_MS = listOf(1000L, 500L, 100L, 10L)
        val LENGTHS_MS = listOf(100L, 500L, 1000L, 2000L)
        val NUMBERS = listOf(2, 5, 10, 20, 50)
        val NUMBER = Regex("\\d{2,6}(?=\\D*$)")
        const val TEN = 10
    }
}
