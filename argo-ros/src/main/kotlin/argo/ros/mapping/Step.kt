package argo.ros.mapping

/** A step on the way to a part of a message. */
internal sealed interface Step {
    data class Name(val name: String) : Step {
        override fun toString() = ".$name"
    }

    /** An item of a list, from 0; negative numbers count from the end. */
    data class Item(val number: Int) : Step {
        fun indexIn(size: Int) = if (number < 0) size + number else number

        override fun toString() = "[$number]"
    }

    /**
     * A sector of a list: the items from [from] up to the item before [to]; null: no limit on that side. Negative numbers count from the
     * end. A sector that ends before it begins goes on at the beginning of the list. Further steps of the path apply to each of its items.
     */
    data class Sector(val from: Int?, val to: Int?) : Step {
        /** Returns the indexes of the sector's items in a list of [size] items; null: the list is too short. */
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

/** Writes [path] as a mapping has it: `poses[0].x`. */
internal fun written(path: Path): String = path.joinToString("").removePrefix(".")
