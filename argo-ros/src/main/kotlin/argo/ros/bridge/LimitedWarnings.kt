package argo.ros.bridge

/** Logs each text once, and at most [MAX_TEXTS] texts, since a bridge may send any number of texts. Safe for use by several threads. */
internal class LimitedWarnings(private val log: (String) -> Unit) : (String) -> Unit {
    private val told = HashSet<String>()

    override fun invoke(text: String) {
        val line = text.replace(CONTROL, "?")
        val count = synchronized(told) { if (told.size <= MAX_TEXTS && told.add(line)) told.size else 0 }
        if (count in 1..MAX_TEXTS) log(line)
        else if (count > MAX_TEXTS) log("$MAX_TEXTS lines have been reported; the rest is left out")
    }

    private companion object {
        val CONTROL = Regex("\\p{Cntrl}")
        const val MAX_TEXTS = 100
    }
}
