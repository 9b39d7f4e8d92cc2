package argo.fleet.cluster

import jdk.net.ExtendedSocketOptions.TCP_KEEPCOUNT
import jdk.net.ExtendedSocketOptions.TCP_KEEPIDLE
import jdk.net.ExtendedSocketOptions.TCP_KEEPINTERVAL
import java.io.EOFException
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.Socket
import java.net.SocketAddress
import java.net.SocketException
import java.net.SocketTimeoutException
import java.security.cert.CertificateException
import java.security.cert.X509Certificate
import javax.net.ssl.SSLContext
import javax.net.ssl.SSLException
import javax.net.ssl.SSLSocket

/** This computer must not connect to the other computer; [message] gives the user the reason. */
private class Refusal(override val message: String) : IOException(message)

/** Holds this computer's greeting and certificates, which start each connection. Checks those of the other end. */
internal class Entrance(
    val greeting: Greeting, private val certificates: FleetCertificates?, private val hosts: Map<String, InetSocketAddress>,
) {
    val context: SSLContext? = certificates?.context()

    /** The addresses from which the fleet's computers connect. Empty if they are not known. */
    val addresses: Set<InetAddress> = hosts.values.mapNotNull { it.address }.toSet()

    /** The number of the fleet's computers, or 0 if it is not known. */
    val computers: Int get() = hosts.size

    /** @throws IOException if this computer must not connect with the computer that shows [other] and [certificate] */
    fun check(other: Greeting, certificate: X509Certificate?) {
        val refusal = greeting.refusalOf(other)
            ?: "${other.name} is none of ${hosts.keys.joinToString()}".takeIf { hosts.isNotEmpty() && other.name !in hosts }
            ?: certificate?.let { certificates?.refusalOf(other.name, it) }
        if (refusal != null) throw Refusal(refusal)
    }
}

/**
 * A TCP connection between two computers, encrypted if they have certificates. JGroups uses it as a plain socket. The socket counts as
 * connected only after both ends have proved that they belong to the fleet.
 */
internal class FleetSocket(private val entrance: Entrance, private val refusals: Refusals) : Socket() {
    private var secured: SSLSocket? = null
    private var other: String? = null // the computer at the other end, after it has proved its name

    override fun getInputStream(): InputStream {
        val stream = secured?.inputStream ?: super.getInputStream()
        return other?.let { Origin.stream(it, stream.buffered(BUFFER)) } ?: stream
    }

    override fun getOutputStream(): OutputStream = secured?.outputStream ?: super.getOutputStream()

    override fun connect(endpoint: SocketAddress, timeout: Int) {
        super.connect(endpoint, timeout)
        val there = (endpoint as InetSocketAddress).let { "${it.address.hostAddress}:${it.port}" }
        begin("$there, where a computer of the fleet should be,") {
            secure(isClient = true)
            say(entrance.greeting.line)
            checkOther(Greeting.parse(Greeting.read(inputStream)))
        }
    }

    /** Exchanges greetings as the accepting end. If the other end does not belong to the fleet, closes the connection and throws. */
    fun answer() = begin("a stranger at ${inetAddress.hostAddress}") {
        secure(isClient = false)
        try {
            checkOther(Greeting.parse(Greeting.read(inputStream)))
        } catch (e: IOException) {
            say(Greeting.refusal(e.message.orEmpty()))
            throw e
        }
        say(entrance.greeting.line)
    }

    private fun checkOther(greeting: Greeting) {
        entrance.check(greeting, secured?.session?.peerCertificates?.firstOrNull() as X509Certificate?)
        other = greeting.name
    }

    private fun secure(isClient: Boolean) {
        val context = entrance.context ?: return
        val tls = context.socketFactory.createSocket(this, inetAddress.hostAddress, port, false) as SSLSocket
        tls.useClientMode = isClient
        if (!isClient) tls.needClientAuth = true
        tls.startHandshake()
        secured = tls
    }

    private fun say(line: String) = outputStream.run {
        write("$line\n".toByteArray())
        flush()
    }

    private fun begin(other: String, steps: () -> Unit) = try {
        soTimeout = PATIENCE_MILLIS
        steps()
        soTimeout = 0
        KEEPING.filterKeys { it in supportedOptions() }.forEach { (option, value) -> setOption(option, value) }
    } catch (e: IOException) {
        close()
        throw IOException("$other ${reason(e)}", e).also { refusals.tell(it.message.orEmpty()) }
    }

    private fun reason(e: IOException): String {
        val causes = generateSequence<Throwable>(e) { it.cause }
        val refusedHere = causes.find { it is CertificateException }
        val own = "the certificate of this computer, which belongs there as fleet/${entrance.greeting.name}.crt"
        return when {
            e is Refusal -> "is refused: ${e.message}"
            // a computer that refuses a certificate says so, but may close the connection before that can be read
            causes.any { it is SocketException || it is EOFException } ->
                "breaks the connection off: ${e.message}" + if (entrance.context == null) "" else "; maybe it does not know $own"
            e is SSLException && refusedHere == null && REFUSED_THERE in e.message.orEmpty() ->
                "does not begin TLS as the fleet does: it does not know $own"
            e is SSLException -> "does not begin TLS as the fleet does: ${(refusedHere ?: e).message}"
            e is SocketTimeoutException -> "does not greet within $PATIENCE_MILLIS ms"
            else -> e.message.orEmpty()
        }
    }

    private companion object {
        /** The TLS alert for a certificate that the other end does not accept. */
        const val REFUSED_THERE = "certificate_unknown"
        const val PATIENCE_MILLIS = 1500

        /**
         * JGroups has the operating system ask whether the other end of an idle connection is there, after two hours. A computer that is
         * lost before it is a member sends nothing, and nothing is sent to it. Its connection ends after these seconds and three questions.
         */
        val KEEPING = mapOf(TCP_KEEPIDLE to 300, TCP_KEEPINTERVAL to 10, TCP_KEEPCOUNT to 3)

        /** The buffer of each connection. The buffer is small, since messages are small. */
        const val BUFFER = 32 shl 10
    }
}
