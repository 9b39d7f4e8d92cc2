package argo.tools.command

import argo.check.rules.editDistance

/** Returns the name in [names] that [word] probably means: only a letter or two, or the case, differ; null: there is none. */
internal fun closest(word: String, names: Collection<String>): String? {
    fun distanceTo(name: String) = editDistance(word.lowercase(), name.lowercase())
    return names.minByOrNull(::distanceTo)?.takeIf { distanceTo(it) <= if (word.length > LONG) 2 else 1 }
}

private const val LONG = 4
