package javino.wire

import io.kotest.property.Arb
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import java.util.HexFormat

/** Texts of any bytes. Bytes with a meaning in frames are more frequent. */
internal fun texts(lengths: IntRange): Arb<String> = Arb.list(
    Arb.choice(Arb.int(0..0xFF), Arb.element(0xA4, 0xA5, 0x04, 0x05, 0x00, 0xFF, 0x66)),
    lengths,
).map { codes -> String(CharArray(codes.size) { codes[it].toChar() }) }

internal fun bytesOf(text: String): ByteArray = text.toByteArray(Charsets.ISO_8859_1)

internal fun textOf(bytes: ByteArray): String = String(bytes, Charsets.ISO_8859_1)

internal const val NONCE = 7

/** A receiver of one direction, with its own clock in milliseconds. */
internal class Receiver(fromBoard: Boolean, nonce: Int = NONCE) {
    val frames = mutableListOf<WireFrame>()
    val decoder = WireDecoder(fromBoard, TIMEOUT_NANOS, { nonce }, frames::add)
    private var now = 0L

    fun receive(bytes: ByteArray, chunk: Int = maxOf(1, bytes.size)): Receiver {
        for (from in bytes.indices step chunk) decoder.accept(bytes, from, minOf(chunk, bytes.size - from), now)
        return this
    }

    fun silence(millis: Long): Receiver {
        now += millis * 1_000_000
        decoder.idle(now)
        return this
    }

    private companion object {
        const val TIMEOUT_NANOS = 100_000_000L
    }
}

/** Returns a frame in the notation of test vectors: CC SS payload, in hexadecimal digits. */
internal fun vectorOf(frame: WireFrame): String {
    val kind = frame.kind().code() or (if (frame.isRefused) WireFrame.REFUSED else 0) or (if (frame.isBusy) WireFrame.BUSY else 0)
    return HexFormat.of().formatHex(byteArrayOf(kind.toByte(), frame.number().toByte()) + bytesOf(frame.payload()))
}

internal fun frameOf(vector: String): WireFrame {
    val text = textOf(HexFormat.of().parseHex(vector))
    val flags = if (text[0].code >= FrameKind.FROM_BOARD) text[0].code and (WireFrame.REFUSED or WireFrame.BUSY) else 0
    val kind = FrameKind.of(text[0].code and flags.inv())
    return WireFrame(kind, flags and WireFrame.REFUSED != 0, flags and WireFrame.BUSY != 0, text[1].code, text.substring(2))
}
