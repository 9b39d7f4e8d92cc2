package argo.ros.bridge

/** Logs each text once and [MAX_TEXTS] texts at most; what a bridge sends may be in them. Safe for use by several threads. */
internal class OnceEach(private val log: (String) -> Unit) : (String) -> Unit {
    private val told = HashSet<String>()

    override fun invoke(text: String) {
        val line = text.replace(CONTROL, "?")
        val count = synchronized(told) { if (told.size <= MAX_TEXTS && told.add(line)) told.size else 0 }
        if (count in 1..MAX_TEXTS) log(line)
        else if (count > MAX_TEXTS) log("there is more to report than $MAX_TEXTS lines, and no more is")
    }

    private companion object {
        val CONTROL = Regex("\\p{Cntrl}")
        const val MAX_TEXTS = 100
    }
}
