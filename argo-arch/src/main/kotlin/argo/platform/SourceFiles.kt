package argo.platform

import kotlin.io.path.Path

/** Returns true if both name one file of a program. Jason names a file by its whole path, by a URL or by its last part. */
internal fun isSameFile(one: String?, other: String?): Boolean {
    if (one == null || other == null) return one == other
    val (path, otherPath) = listOf(one, other).map { Path(it.removePrefix("file:")).normalize() }
    return path.endsWith(otherPath) || otherPath.endsWith(path)
}
