package argo.fleet.cluster

import java.io.IOException
import java.io.InputStream
import java.security.MessageDigest
import java.util.HexFormat

/**
 * The first line of a connection, from either end: `argo-fleet 2 garden scout1 5f3a…`. JGroups therefore reads no byte from other programs,
 * and none from computers with another fleet, version or list of hosts.
 *
 * @property hosts a digest of the fleet's computers and their addresses. With different names, two parts of a fleet could both count a
 * majority. With different addresses, two computers could have one name
 */
internal data class Greeting(val fleet: String, val name: String, val hosts: String) {
    val line: String get() = "$WORD $FORMAT $fleet $name $hosts"

    /** Returns the reason why this computer cannot connect to the sender of [other], or null if it can. */
    fun refusalOf(other: Greeting): String? = when {
        other.fleet != fleet -> "${other.name} belongs to the fleet ${other.fleet}, and $name to $fleet"
        other.hosts != hosts -> "the hosts of ${other.name} have other names or addresses than those of $name: give both the same project"
        else -> null
    }

    companion object {
        private const val WORD = "argo-fleet"
        private const val REFUSED = "refused "

        /** Increase this number with each change of frames or of JGroups' messages. */
        private const val FORMAT = 2
        private const val MAX_LINE = 400
        private const val PRINTABLE = 40
        private val FORM = Regex("$WORD (\\d{1,9})(?: ([A-Za-z0-9_.-]+) ([A-Za-z0-9_.-]+) (any|[0-9a-f]+))?(?: .*)?")

        fun of(settings: ClusterSettings): Greeting {
            val hosts = settings.hosts.toSortedMap().map { (name, at) -> "$name=${at.hostString}:${at.port}" }.joinToString(" ")
            val digest = HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(hosts.toByteArray())).take(16)
            return Greeting(settings.fleet, settings.here, if (settings.hosts.isEmpty()) "any" else digest)
        }

        fun refusal(reason: String) = REFUSED + reason

        /** @throws IOException if the line refuses the connection, or is in another format; the message is for the user */
        fun parse(line: String): Greeting {
            if (line.startsWith(REFUSED)) throw IOException("refuses the connection: ${printable(line.removePrefix(REFUSED), MAX_LINE)}")
            val (format, fleet, name, hosts) = FORM.matchEntire(line)?.destructured
                ?: throw IOException("speaks no language of a fleet: it sent \"${printable(line, PRINTABLE)}\"")
            if (format.toInt() != FORMAT || name.isEmpty()) {
                throw IOException("speaks version $format of the fleet's language, and this computer $FORMAT: use one argo-fleet.jar")
            }
            return Greeting(fleet, name, hosts)
        }

        /** Reads one line, and no byte after its end. */
        fun read(from: InputStream): String {
            val line = StringBuilder()
            while (line.length < MAX_LINE) {
                val byte = from.read()
                if (byte < 0) throw IOException("closed the connection after ${line.length} characters")
                if (byte == '\n'.code) break
                line.append(byte.toChar())
            }
            return line.toString()
        }

        private fun printable(text: String, length: Int) = text.take(length).map { if (it in ' '..'~') it else '?' }.joinToString("")
    }
}
