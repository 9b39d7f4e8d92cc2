package javino

/** A decoder with a clock of its own. Keeps the delivered frames. */
internal class DecoderProbe(private val timeoutNanos: Long = 100) {
    val delivered = mutableListOf<Frame>()
    val decoder = FrameDecoder(timeoutNanos, delivered::add)
    private var now = 0L

    fun feed(bytes: ByteArray, chunk: Int = bytes.size): DecoderProbe {
        for (start in bytes.indices step maxOf(chunk, 1)) {
            decoder.accept(bytes, start, minOf(chunk, bytes.size - start), ++now)
        }
        return this
    }

    fun feed(text: String): DecoderProbe = feed(text.toByteArray(Charsets.ISO_8859_1))

    /** Advances the clock by more than the inter-byte timeout. */
    fun silence(): DecoderProbe {
        now += timeoutNanos + 1
        decoder.idle(now)
        return this
    }

    fun texts(): List<String> = delivered.map { it.text() }
}
