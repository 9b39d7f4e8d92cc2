package argo.ros.bridge

import java.security.MessageDigest
import java.util.UUID

/**
 * Returns the operation by which a client logs in for [LASTING_S] s, from [nowSeconds] since 1970 on. As `rosauth` defines it, the bridge
 * checks a SHA-512 over [secret] and the operation's other fields, and lets the clocks differ by up to 5 s.
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
