package argo.testkit

import javino.Transport

/**
 * The agent's end of [line]. One in [oneIn] bytes has a wrong bit, in each direction. [oneIn] may change. 0 means no wrong bytes. Wrong
 * bytes have equal distances, so that all runs are equal.
 */
internal class GarbledLine(private val line: Transport, private val oneIn: () -> Int) : Transport by line {
    private var received = 0
    private var sent = 0

    // `by line` does not delegate functions that have a body in the interface
    override fun mayVanish() = line.mayVanish()

    override fun doubt(): String = line.doubt()

    override fun isWritableNow(unread: Long) = line.isWritableNow(unread)

    override fun read(b: ByteArray, off: Int, len: Int, timeoutMillis: Int): Int {
        val count = line.read(b, off, len, timeoutMillis)
        for (i in off until off + count) if (isNextWrong(++received)) b[i] = wrong(b[i])
        return count
    }

    override fun write(b: ByteArray, off: Int, len: Int, timeoutMillis: Int) {
        if (oneIn() == 0) return line.write(b, off, len, timeoutMillis)
        val passed = b.copyOfRange(off, off + len)
        for (i in passed.indices) if (isNextWrong(++sent)) passed[i] = wrong(passed[i])
        line.write(passed, 0, len, timeoutMillis)
    }

    private fun isNextWrong(count: Int) = oneIn().let { it > 0 && count % it == 0 }

    private fun wrong(byte: Byte): Byte = (byte.toInt() xor WRONG_BIT).toByte()

    private companion object {
        const val WRONG_BIT = 0x10
    }
}
