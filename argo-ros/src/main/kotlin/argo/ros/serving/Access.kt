package argo.ros.serving

import java.net.InetSocketAddress
import java.net.URI
import java.net.URISyntaxException
import java.net.URLDecoder
import java.security.MessageDigest

/** A server cannot be opened, as [message] says. */
internal class RefusedServer(message: String) : Exception(message)

/**
 * The address at which a server listens, and the token that it wants: `9090`, `0.0.0.0:9090?token=…`.
 *
 * @property address the network address; the port 0 is any that is free
 * @property token the token that clients must show; null: every program of this computer may connect
 */
internal class Access(val address: InetSocketAddress, private val token: String?) {
    /**
     * Returns the reason for refusing a client, in words; null: it is accepted.
     *
     * A page of another site can make its browser connect to this computer, but cannot hide its origin, and does not know the token.
     *
     * @param path the path of the client's request, with its query
     * @param authorization the header `Authorization`
     * @param origin the header `Origin`, which browsers send
     */
    fun refusal(path: String, authorization: String?, origin: String?): String? {
        val shown = authorization?.removePrefix("Bearer ")?.trim().orEmpty().ifEmpty { tokenIn(path) }
        return when {
            token != null -> "the token is wrong, or there is none".takeUnless { isSame(token, shown) }
            origin.isNullOrEmpty() || isLocal(origin) -> null
            else -> "the page $origin is not of this computer"
        }
    }

    private fun isSame(one: String, other: String) = MessageDigest.isEqual(one.toByteArray(), other.toByteArray())

    private fun isLocal(origin: String): Boolean = try {
        URI(origin).host in LOCAL
    } catch (_: URISyntaxException) {
        false
    }

    private fun tokenIn(path: String): String = path.substringAfter('?', "").split('&')
        .firstNotNullOfOrNull { it.removePrefix("token=").takeIf { rest -> rest != it } }?.let(::decoded).orEmpty()

    private fun decoded(text: String) = try {
        URLDecoder.decode(text, Charsets.UTF_8)
    } catch (_: IllegalArgumentException) {
        ""
    }

    companion object {
        private val LOCAL = setOf("localhost", "127.0.0.1", "[::1]")
        private val FORM = Regex("(?:(\\[[0-9A-Fa-f:.]+]|[A-Za-z0-9._-]+):)?([0-9]{1,5})(?:\\?token=(.*))?")
        private const val MAX_PORT = 65_535

        /** The shortest token, in characters. */
        const val MIN_TOKEN = 16

        /**
         * Reads `PORT`, `HOST:PORT` or `HOST:PORT?token=TOKEN`. Without a host it is this computer's own address.
         *
         * @param token the token, given outside of the text; null: the text may have it
         * @throws RefusedServer with the reason
         */
        fun of(text: String, token: String? = null): Access {
            val (host, number, written) = FORM.matchEntire(text.trim())?.destructured ?: throw malformed(text)
            val port = number.toInt().takeIf { it <= MAX_PORT } ?: throw malformed(text)
            val address = InetSocketAddress(if (host.isEmpty()) LOOPBACK else host, port)
            val machine = address.address ?: throw RefusedServer("there is no host $host")
            val secret = token ?: written.ifEmpty { null }
            if (secret == null && !machine.isLoopbackAddress) throw RefusedServer(
                "whoever reaches $host can drive the robot: give a token of at least $MIN_TOKEN characters, as $host:$port?token=…",
            )
            if (secret != null && secret.length < MIN_TOKEN) throw RefusedServer("a token has at least $MIN_TOKEN characters")
            return Access(address, secret)
        }

        private const val LOOPBACK = "127.0.0.1"

        private fun malformed(text: String) = RefusedServer("'$text' is no address: that is PORT, HOST:PORT or HOST:PORT?token=TOKEN")
    }
}
