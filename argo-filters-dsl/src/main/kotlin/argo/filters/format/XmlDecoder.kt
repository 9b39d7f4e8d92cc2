package argo.filters.format

import argo.filters.FilterException
import argo.filters.Problem
import java.nio.charset.Charset

/**
 * Decodes an XML document's bytes as its byte-order mark or its declaration says; UTF-8 where there is neither.
 *
 * It is done here, not left to the XML parser, since positions are found in the decoded text.
 */
internal class XmlDecoder(private val source: String) {

    /** @throws FilterException if the encoding is unknown or the bytes are not in it */
    fun decode(bytes: ByteArray): String = decodeStrictly(bytes, charset(bytes), source)

    private fun charset(bytes: ByteArray): Charset = when {
        bytes.startsWith(0xEF, 0xBB, 0xBF) -> Charsets.UTF_8
        bytes.startsWith(0, 0, 0xFE, 0xFF) -> Charsets.UTF_32BE
        bytes.startsWith(0xFF, 0xFE, 0, 0) -> Charsets.UTF_32LE
        bytes.startsWith(0xFE, 0xFF) || bytes.startsWith(0, '<'.code) -> Charsets.UTF_16BE
        bytes.startsWith(0xFF, 0xFE) || bytes.startsWith('<'.code, 0) -> Charsets.UTF_16LE
        else -> declared(bytes)
    }

    private fun declared(bytes: ByteArray): Charset {
        val start = String(bytes, 0, minOf(bytes.size, DECLARATION_LENGTH), Charsets.ISO_8859_1)
        val encoding = DECLARATION.find(start)?.groupValues?.get(1) ?: return Charsets.UTF_8
        if (!isSupported(encoding)) {
            throw FilterException(listOf(Problem(source, 1, 1, "the encoding '$encoding', which is unknown here; UTF-8 is a good choice")))
        }
        return Charset.forName(encoding)
    }

    private fun isSupported(encoding: String) = CHARSET_NAME.matches(encoding) && Charset.isSupported(encoding)

    private fun ByteArray.startsWith(vararg start: Int) =
        size >= start.size && start.indices.all { this[it] == start[it].toByte() }

    private companion object {
        const val DECLARATION_LENGTH = 1024
        val DECLARATION = Regex("""\A<\?xml[^>]*?\sencoding\s*=\s*["']([^"']*)["']""")
        val CHARSET_NAME = Regex("[A-Za-z0-9][A-Za-z0-9._:+-]*")
    }
}
