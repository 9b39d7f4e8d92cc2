package argo.tools.command

import java.math.BigDecimal

internal fun nanosOf(seconds: BigDecimal): Long? {
    val ns = seconds.movePointRight(NANO_DIGITS).toBigInteger()
    return if (ns.signum() < 0 || ns.bitLength() >= Long.SIZE_BITS - 1) null else ns.toLong()
}

internal fun secondsIn(ns: Long): Double = ns / 1e9

private const val NANO_DIGITS = 9
