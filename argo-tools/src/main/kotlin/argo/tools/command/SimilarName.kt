package argo.tools.command

import argo.check.rules.editDistance

/** Returns the name in [names] that [word] probably means, or null if there is none. Only case or one or two letters may differ. */
internal fun closest(word: String, names: Collection<String>): String? {
    fun distanceTo(name: String) = editDistance(word.lowercase(), name.lowercase())
    return names.minByOrNull(::distanceTo)?.takeIf { distanceTo(it) <= if (word.length > LONG) 2 else 1 }
}

private const val LONG = 4
