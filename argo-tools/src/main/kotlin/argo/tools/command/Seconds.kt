package argo.tools.command

import java.math.BigDecimal

/** So many seconds in ns; null: a negative number, or more than can be counted. */
internal fun nanosOf(seconds: BigDecimal): Long? {
    val ns = seconds.movePointRight(NANO_DIGITS).toBigInteger()
    return if (ns.signum() < 0 || ns.bitLength() >= Long.SIZE_BITS - 1) null else ns.toLong()
}

private const val NANO_DIGITS = 9
