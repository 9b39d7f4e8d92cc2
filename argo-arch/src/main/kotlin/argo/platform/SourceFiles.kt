package argo.platform

import java.net.URI
import java.net.URISyntaxException
import java.nio.file.Path
import kotlin.io.path.Path

/** Returns true if both names mean one file of a program. Jason names a file by its whole path, by a URL or by its last part. */
internal fun isSameFile(one: String?, other: String?): Boolean {
    if (one == null || other == null) return one == other
    val (path, otherPath) = listOf(one, other).map { Path(it.removePrefix("file:")).normalize() }
    return path.endsWith(otherPath) || otherPath.endsWith(path)
}

/** Returns the path of the file at [address]; null if the file is in a jar, on the class path or on another computer. */
fun pathOf(address: String): Path? = try {
    when {
        address.startsWith("file:/") -> Path.of(URI(address))
        address.startsWith("file:") -> Path.of(address.removePrefix("file:"))
        ':' in address.drop(2) -> null // a URL; the colon of a Windows drive is the second character
        else -> Path.of(address)
    }?.toAbsolutePath()?.normalize()
} catch (_: URISyntaxException) {
    null
} catch (_: IllegalArgumentException) {
    null
}
