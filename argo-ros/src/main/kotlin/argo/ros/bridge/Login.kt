package argo.ros.bridge

import java.security.MessageDigest
import java.util.UUID

/**
 * Returns the operation that logs in a client for [LASTING_S] s from [nowSeconds] on. [nowSeconds] counts from 1970. The bridge checks a
 * SHA-512 hash of [secret] and the other fields, as `rosauth` defines it. The clocks may differ by up to 5 s.
 */
internal fun login(secret: String, destination: String, nowSeconds: Long, random: String = "${UUID.randomUUID()}"): String {
    val end = nowSeconds + LASTING_S
    val digest = MessageDigest.getInstance("SHA-512").digest("$secret$CLIENT$destination$random$nowSeconds$LEVEL$end".toByteArray())
    return operation(
        "auth", "mac" to digest.joinToString("") { "%02x".format(it) }, "client" to CLIENT, "dest" to destination, "rand" to random,
        "t" to nowSeconds, "level" to LEVEL, "end" to end,
    )
}

private const val CLIENT = "argo"
private const val LEVEL = "user"
private const val LASTING_S = 60L
