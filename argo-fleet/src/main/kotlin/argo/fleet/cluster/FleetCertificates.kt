package argo.fleet.cluster

import javino.tcp.TlsFolder
import java.io.IOException
import java.net.Socket
import java.nio.file.Files
import java.nio.file.Path
import java.security.KeyStore
import java.security.cert.CertificateException
import java.security.cert.X509Certificate
import javax.net.ssl.KeyManagerFactory
import javax.net.ssl.SSLContext
import javax.net.ssl.SSLEngine
import javax.net.ssl.TrustManager
import javax.net.ssl.X509ExtendedTrustManager
import kotlin.io.path.extension
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.nameWithoutExtension

/**
 * The certificates of a fleet, in the folder of those for `tls://`. `computer.crt` and `computer.key` belong to this computer, and
 * `fleet/scout1.crt` to the computer `scout1`. Only the certificates in `fleet/` are trusted. All computers may share one certificate.
 *
 * @throws IOException if a file is missing or cannot be read; the message is for the user
 */
internal class FleetCertificates(folder: Path) {
    private val own: TlsFolder.Identity
    private val others: Map<String, X509Certificate>
    private val where = folder.resolve("fleet")

    init {
        val files = TlsFolder(folder)
        own = files.computer().orElseThrow {
            IOException("there is no certificate of this computer: put it into ${files.computerFile()}, and its key beside it")
        }
        val found = if (Files.isDirectory(where)) where.listDirectoryEntries().filter { it.extension == "crt" } else emptyList()
        others = found.associate { it.nameWithoutExtension to TlsFolder.certificates(it)[0] }
    }

    /**
     * Returns TLS for both ends of a connection. The context shows this computer's certificate, and trusts only certificates of the fleet.
     */
    fun context(): SSLContext {
        val keys = KeyStore.getInstance("PKCS12").apply { load(null, null) }
        keys.setKeyEntry("computer", own.key(), CharArray(0), own.chain())
        val managers = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm()).apply { init(keys, CharArray(0)) }.keyManagers
        return SSLContext.getInstance("TLSv1.3").apply { init(managers, arrayOf<TrustManager>(Trust()), null) }
    }

    /** Returns the reason why the computer with [certificate] cannot be [name], or null if it can. */
    fun refusalOf(name: String, certificate: X509Certificate): String? {
        val owners = others.filterValues { it == certificate }.keys
        return if (name in owners || owners.isEmpty()) null
        else "the computer that calls itself $name has the certificate of ${owners.joinToString()}"
    }

    private fun check(chain: Array<X509Certificate>) {
        val shown = chain[0]
        if (shown != own.chain()[0] && shown !in others.values) {
            val digest = TlsFolder.fingerprint(shown)
            throw CertificateException("it shows a certificate that is not in $where, $digest; if it is of the fleet, put it there")
        }
        shown.checkValidity()
    }

    private inner class Trust : X509ExtendedTrustManager() {
        override fun checkClientTrusted(chain: Array<X509Certificate>, type: String) = check(chain)
        override fun checkServerTrusted(chain: Array<X509Certificate>, type: String) = check(chain)
        override fun checkClientTrusted(chain: Array<X509Certificate>, type: String, socket: Socket) = check(chain)
        override fun checkServerTrusted(chain: Array<X509Certificate>, type: String, socket: Socket) = check(chain)
        override fun checkClientTrusted(chain: Array<X509Certificate>, type: String, engine: SSLEngine) = check(chain)
        override fun checkServerTrusted(chain: Array<X509Certificate>, type: String, engine: SSLEngine) = check(chain)
        override fun getAcceptedIssuers(): Array<X509Certificate> = emptyArray()
    }
}
