package argo.sensing

/** The policy by which snapshots of the sensors are handed to the agent: `argo_sensing` in the `.mas2j`. */
internal enum class SensingPolicy(val word: String) {
    /** The newest snapshot, when the agent has taken in the one before: see `argo.perception.HandOver`. */
    FRESH("fresh"),

    /** Each snapshot in order, even if the agent has not finished the work of earlier ones. */
    EVERY("every"),

    /**
     * As published at EMAS 2016: the reasoning cycle requests and awaits each snapshot, and commands are written at once. For experiments:
     * such an agent falls behind the world.
     */
    IN_CYCLE("in_cycle");

    companion object {
        fun of(word: String): SensingPolicy? = entries.find { it.word == word }

        val words: String get() = entries.joinToString(", ") { it.word }
    }
}
