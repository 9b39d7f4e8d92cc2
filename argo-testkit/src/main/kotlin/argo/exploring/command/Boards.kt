package argo.exploring.command

import argo.exploring.Exploration
import argo.exploring.ExploredBoard
import java.lang.reflect.InvocationTargetException
import java.lang.reflect.Modifier

/**
 * Describes a board by [text]: its port, then the percepts of each sensor. Example: `ttyACM0 dist(front,5..200) line(on)|line(off)|`.
 *
 * @throws IllegalArgumentException if [text] describes no board
 */
internal fun Exploration.described(text: String, isVersion2: Boolean) {
    val words = text.trim().split(Regex("\\s+"))
    require(words.first().isNotEmpty()) { "a board is its port and its sensors, as \"ttyACM0 dist(front,5..200) line(on)|line(off)|\"" }
    board(words.first()) {
        if (isVersion2) version2()
        words.drop(1).forEach { sensorIn(it) }
    }
}

private fun ExploredBoard.sensorIn(text: String) {
    val ranges = RANGE.findAll(text).toList()
    when {
        ranges.size == 1 -> sensor(text.replaceRange(ranges.single().range, "%d"), rangeOf(ranges.single()))
        ranges.size > 1 -> throw IllegalArgumentException("$text has ${ranges.size} ranges; a sensor has one")
        '|' in text -> sensor(*text.split('|').toTypedArray())
        else -> throw IllegalArgumentException(
            "$text always shows the same: a sensor has a range, as dist(front,5..200), or several percepts, as line(on)|line(off)|",
        )
    }
}

private fun rangeOf(text: MatchResult): IntRange {
    val (first, last) = text.groupValues.drop(1).map { it.toIntOrNull() }
    require(first != null && last != null && last > first && last.toLong() - first <= MOST_NUMBERS) {
        "${text.value} is no range: it goes from the least to the greatest number, and has at most $MOST_NUMBERS"
    }
    return first..last
}

private const val MOST_NUMBERS = 100_000

private val RANGE = Regex("(-?\\d+)\\.\\.(-?\\d+)")

/**
 * Calls the functions of the class [name] that describe an exploration. The functions are static and have a parameter of type
 * [Exploration]. A Kotlin file has `fun Exploration.boards()`.
 *
 * @throws IllegalArgumentException if the class or such a function does not exist
 */
internal fun Exploration.describedIn(name: String) {
    val type = try {
        Class.forName(name)
    } catch (_: ClassNotFoundException) {
        throw IllegalArgumentException("there is no class $name on the class path; of a file robot.kt in no package it is RobotKt")
    }
    val functions = type.methods.filter { Modifier.isStatic(it.modifiers) && it.parameterTypes.toList() == listOf(Exploration::class.java) }
    val function = requireNotNull(functions.singleOrNull()) {
        "$name has ${functions.size} functions that describe an exploration; it is to have one, as fun Exploration.boards() { … }"
    }
    try {
        function.invoke(null, this)
    } catch (failed: InvocationTargetException) {
        throw failed.targetException
    }
    describedBy = listOf(type.packageName, function.name).filter { it.isNotEmpty() }.joinToString(".")
}
