package javino.tcp

import java.io.ByteArrayInputStream
import java.nio.file.Path
import java.security.KeyPairGenerator
import java.security.KeyStore
import java.security.Signature
import java.security.cert.CertificateFactory
import java.security.cert.X509Certificate
import java.time.Duration
import java.time.Instant
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import java.util.HexFormat
import kotlin.io.path.writeText

/**
 * A self-signed certificate, valid for [days] days. The validity begins [startDays] days from now. This process makes the certificate,
 * because `keytool` takes too long on a busy machine.
 */
internal class TestCertificate(name: String, startDays: Long = -1, days: Long = 30, algorithm: String = "EC") {
    private val keys = KeyPairGenerator.getInstance(algorithm).apply { initialize(if (algorithm == "EC") 256 else 2048) }.generateKeyPair()
    private val signing = if (algorithm == "EC") ECDSA else RSA

    val certificate: X509Certificate = run {
        val owner = sequence(der(SET, sequence(COMMON_NAME, der(UTF8, name.toByteArray()))))
        val start = Instant.now() + Duration.ofDays(startDays)
        val validity = sequence(der(UTC_TIME, time(start)), der(UTC_TIME, time(start + Duration.ofDays(days))))
        val certified = sequence(der(INTEGER, byteArrayOf(1)), signing, owner, validity, owner, keys.public.encoded)
        val signature = Signature.getInstance("SHA256with${if (algorithm == "EC") "ECDSA" else algorithm}").run {
            initSign(keys.private)
            update(certified)
            sign()
        }
        val whole = sequence(certified, signing, der(BIT_STRING, byteArrayOf(0) + signature))
        CertificateFactory.getInstance("X.509").generateCertificate(ByteArrayInputStream(whole)) as X509Certificate
    }

    val store: KeyStore = KeyStore.getInstance("PKCS12").apply {
        load(null, null)
        setKeyEntry("own", keys.private, PASSWORD, arrayOf(certificate))
    }

    fun write(crt: Path, key: Path? = null) {
        crt.writeText(TlsFolder.pem("CERTIFICATE", certificate.encoded))
        key?.writeText(TlsFolder.pem("PRIVATE KEY", keys.private.encoded))
    }

    companion object {
        val PASSWORD = "secret".toCharArray()

        val BOARD by lazy { TestCertificate("board") }

        // tags and values of ASN.1
        private const val INTEGER = 0x02
        private const val BIT_STRING = 0x03
        private const val UTF8 = 0x0C
        private const val UTC_TIME = 0x17
        private const val SEQUENCE = 0x30
        private const val SET = 0x31
        private val COMMON_NAME = HexFormat.of().parseHex("0603550403")
        private val ECDSA = sequence(HexFormat.of().parseHex("06082a8648ce3d040302"))
        private val RSA = sequence(HexFormat.of().parseHex("06092a864886f70d01010b0500"))

        private fun sequence(vararg parts: ByteArray) = der(SEQUENCE, parts.reduce(ByteArray::plus))

        private fun time(at: Instant) =
            DateTimeFormatter.ofPattern("yyMMddHHmmss'Z'").withZone(ZoneOffset.UTC).format(at).toByteArray()

        private fun der(tag: Int, value: ByteArray): ByteArray {
            val size = value.size
            val length = if (size < 0x80) listOf(size) else if (size < 0x100) listOf(0x81, size) else listOf(0x82, size shr 8, size)
            return (listOf(tag) + length).map(Int::toByte).toByteArray() + value
        }
    }
}
