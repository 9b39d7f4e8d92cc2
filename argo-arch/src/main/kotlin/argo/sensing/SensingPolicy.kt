package argo.sensing

/** The policy that decides when the agent gets snapshots of the sensors: `argo_sensing` in the `.mas2j`. */
internal enum class SensingPolicy(val word: String) {
    /** The agent gets the newest snapshot when it has done the work of the previous one, see `argo.perception.FreshHandOver`. */
    FRESH("fresh"),

    /** The agent gets each snapshot, in order, even if it has not done the work of earlier ones. */
    EVERY("every"),

    /**
     * The policy published at EMAS 2016: the reasoning cycle requests and awaits each snapshot, and commands are written at once. Only for
     * experiments, since an agent with this policy falls behind the world.
     */
    IN_CYCLE("in_cycle");

    companion object {
        fun of(word: String): SensingPolicy? = entries.find { it.word == word }

        val words: String get() = entries.joinToString(", ") { it.word }
    }
}
