package argo.fleet.cluster

import java.time.Duration

/** Logs refused connections. Logs each reason only once in a while, since refused computers try repeatedly. */
internal class Refusals(
    private val now: () -> Long = System::nanoTime, private val log: (String) -> Unit = { LOG.log(System.Logger.Level.WARNING, it) },
) {
    private val told = object : LinkedHashMap<String, Long>() {
        override fun removeEldestEntry(eldest: Map.Entry<String, Long>) = size > MAX_TOLD
    }

    @Synchronized
    fun tell(reason: String) {
        val last = told[reason]
        if (last != null && now() - last < AGAIN_NANOS) return
        told.remove(reason)
        told[reason] = now()
        log("$reason (told once in ${Duration.ofNanos(AGAIN_NANOS).toMinutes()} minutes)")
    }

    private companion object {
        val LOG: System.Logger = System.getLogger(Cluster::class.java.name)
        const val MAX_TOLD = 64
        val AGAIN_NANOS = Duration.ofMinutes(10).toNanos()
    }
}
