package argo.fleet.cluster

import java.time.Duration

/**
 * Logs refused connections. Logs each reason only once in a while, since refused computers try repeatedly, and [MAX_TOLD] reasons at most in
 * that time, since a stranger can make up any number of them. The text in quotes that a stranger has sent makes no other reason.
 */
internal class Refusals(
    private val now: () -> Long = System::nanoTime, private val log: (String) -> Unit = { LOG.log(System.Logger.Level.WARNING, it) },
) {
    private val told = HashMap<String, Long>()

    @Synchronized
    fun tell(reason: String) {
        val kind = reason.substringBefore('"')
        told.values.removeIf { now() - it >= AGAIN_NANOS }
        if (kind in told || told.size > MAX_TOLD) return
        told[kind] = now()
        val minutes = Duration.ofNanos(AGAIN_NANOS).toMinutes()
        log(if (told.size <= MAX_TOLD) "$reason (told once in $minutes minutes)" else "for $minutes minutes no further reason is told")
    }

    private companion object {
        val LOG: System.Logger = System.getLogger(Cluster::class.java.name)
        const val MAX_TOLD = 64
        val AGAIN_NANOS = Duration.ofMinutes(10).toNanos()
    }
}
