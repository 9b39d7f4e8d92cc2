package javino.virtual

import java.util.SplittableRandom
import kotlin.math.ln
import kotlin.math.pow

/**
 * Random faults of a line, byte by byte.
 *
 * @param bitErrors probability that a bit is inverted
 * @param lost probability that a byte does not arrive
 * @param doubled probability that a byte arrives twice
 * @param late probability that a byte and all later bytes are delayed by up to [latestNanos]
 */
internal class RandomFaults(
    private val bitErrors: Double = 0.0,
    private val lost: Double = 0.0,
    private val doubled: Double = 0.0,
    private val late: Double = 0.0,
    private val latestNanos: Long = 1,
    seed: Long,
) : LineFaults {
    private val random = SplittableRandom(seed)
    private val wrongByte = 1 - (1 - bitErrors).pow(8)

    /** True if the last bytes arrived undamaged, in time or late. */
    var intact = true
        private set

    /** The longest delay of the last bytes, in ns. */
    var lateNanos = 0L
        private set

    override fun pass(bytes: ByteArray): List<Piece> {
        intact = true
        lateNanos = 0
        val faults =
            bytes.indices.mapNotNull { i -> random.nextDouble().takeIf { it < wrongByte + lost + doubled + late }?.let { i to it } }
        if (faults.isEmpty()) return listOf(Piece(bytes))
        val pieces = mutableListOf<Piece>()
        var from = 0
        for ((i, chance) in faults) {
            pieces += Piece(bytes.copyOfRange(from, i))
            pieces += faulty(bytes[i], chance)
            from = i + 1
        }
        return pieces + Piece(bytes.copyOfRange(from, bytes.size))
    }

    private fun faulty(byte: Byte, chance: Double): Piece = when {
        chance < wrongByte + lost + doubled -> Piece(damaged(byte, chance)).also { intact = false }
        else -> Piece(byteArrayOf(byte), random.nextLong(latestNanos)).also { lateNanos = maxOf(lateNanos, it.lateNanos) }
    }

    private fun damaged(byte: Byte, chance: Double): ByteArray = when {
        chance < wrongByte -> byteArrayOf((byte.toInt() xor wrongBits()).toByte())
        chance < wrongByte + lost -> byteArrayOf()
        else -> byteArrayOf(byte, byte)
    }

    /** Chooses the inverted bits of a byte, at least one. */
    private fun wrongBits(): Int {
        val first = (ln(1 - random.nextDouble() * wrongByte) / ln(1 - bitErrors)).toInt().coerceIn(0, 7)
        return (first + 1..7).fold(1 shl first) { bits, bit -> if (random.nextDouble() < bitErrors) bits or (1 shl bit) else bits }
    }
}

/** Applies [fault] only to write number [turn], counted from 1. */
internal class OneFault(private val turn: Int, private val fault: (ByteArray) -> List<Piece>) : LineFaults {
    private var writes = 0

    override fun pass(bytes: ByteArray): List<Piece> = if (++writes == turn) fault(bytes) else listOf(Piece(bytes))
}
