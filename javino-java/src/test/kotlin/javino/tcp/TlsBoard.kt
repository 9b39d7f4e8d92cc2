package javino.tcp

import javino.LineSettings
import java.io.InputStream
import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.security.KeyStore
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import javax.net.ssl.KeyManagerFactory
import javax.net.ssl.SSLContext
import javax.net.ssl.SSLSocket
import javax.net.ssl.TrustManagerFactory
import kotlin.concurrent.thread

/**
 * A board on the loopback address that speaks TLS with the certificate [own]. If [computer] is given, asks for the computer's
 * certificate.
 */
internal class TlsBoard(own: TestCertificate, private val computer: TestCertificate? = null) : AutoCloseable {
    private val server = ServerSocket(0, 5, InetAddress.getLoopbackAddress()).apply { receiveBufferSize = 4096 }
    private val context = SSLContext.getInstance("TLS").apply {
        val keys = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm())
        keys.init(own.store, TestCertificate.PASSWORD)
        val trusted = computer?.let {
            val known = KeyStore.getInstance("PKCS12").apply { load(null, null); setCertificateEntry("computer", it.certificate) }
            TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm()).apply { init(known) }.trustManagers
        }
        init(keys.keyManagers, trusted, null)
    }
    val number: Int = server.localPort
    val port: String = "tls://127.0.0.1:$number"

    /**
     * Accepts the next connection on its own thread.
     *
     * @param between wraps the TCP socket under TLS
     */
    fun accept(breaks: Boolean = false, between: (Socket) -> Socket = { it }): CompletableFuture<TlsTransport> {
        val accepted = CompletableFuture<TlsTransport>()
        thread(isDaemon = true) {
            runCatching {
                val plain = between(server.accept())
                if (breaks) plain.setSoLinger(true, 0)
                val tls = context.socketFactory.createSocket(plain, "127.0.0.1", number, true) as SSLSocket
                tls.useClientMode = false
                if (computer != null) tls.needClientAuth = true
                tls.startHandshake()
                TlsTransport(tls, tls.inputStream, plain, "the board's end", LineSettings.defaults()) { "broken: ${it.message}" }
            }.fold(accepted::complete, accepted::completeExceptionally)
        }
        return accepted
    }

    override fun close() = server.close()
}

internal fun CompletableFuture<TlsTransport>.end(): TlsTransport = get(20, TimeUnit.SECONDS)

/** Sends bytes one by one with a pause after each, so no TLS record arrives at once. */
internal class DrippingSocket(private val socket: Socket, private val pauseMillis: Long) : Socket() {
    @Volatile
    var drips = false

    override fun getInputStream(): InputStream = socket.getInputStream()

    override fun getOutputStream() = object : java.io.OutputStream() {
        override fun write(b: Int) = write(byteArrayOf(b.toByte()))

        override fun write(b: ByteArray, off: Int, len: Int) {
            if (!drips) return socket.getOutputStream().write(b, off, len)
            for (i in off until off + len) {
                socket.getOutputStream().write(b, i, 1)
                TimeUnit.MILLISECONDS.sleep(pauseMillis)
            }
        }
    }

    override fun isConnected() = true

    override fun setSoTimeout(timeout: Int) = socket.setSoTimeout(timeout)

    override fun getSoTimeout() = socket.soTimeout

    override fun getSoLinger() = socket.soLinger

    override fun getInetAddress(): InetAddress = socket.inetAddress

    override fun getPort() = socket.port

    override fun close() = socket.close()
}
