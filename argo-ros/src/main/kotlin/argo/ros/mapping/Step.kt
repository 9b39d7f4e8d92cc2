package argo.ros.mapping

/** A step of a path into a message. */
internal sealed interface Step {
    data class Name(val name: String) : Step {
        override fun toString() = ".$name"
    }

    /** An item of a list, counted from 0. Negative numbers count from the end. */
    data class Item(val number: Int) : Step {
        fun indexIn(size: Int) = if (number < 0) size + number else number

        override fun toString() = "[$number]"
    }

    /**
     * A range of list items, from [from] up to the item before [to]. Null means no limit on that side. Negative numbers count from the end.
     * If the range ends before it begins, it wraps around to the beginning of the list. Further steps of the path apply to each item.
     */
    data class Sector(val from: Int?, val to: Int?) : Step {
        /** Returns the indexes of the range in a list of [size] items, or null if the list is too short. */
        fun indicesIn(size: Int): List<Int>? {
            val (start, end) = listOf(from ?: 0, to ?: size).map { if (it < 0) size + it else it }
            return when {
                start !in 0..size || end !in 0..size -> null
                start <= end -> (start until end).toList()
                else -> (start until size) + (0 until end)
            }
        }

        override fun toString() = "[${from ?: ""}:${to ?: ""}]"
    }
}

internal typealias Path = List<Step>

/** Writes [path] in the syntax of mappings: `poses[0].x`. */
internal fun written(path: Path): String = path.joinToString("").removePrefix(".")
