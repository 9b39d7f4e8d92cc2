package argo.sensing

/** The policy by which snapshots of the sensors are handed to the agent: `argo_sensing` in the `.mas2j`. */
internal enum class SensingPolicy(val word: String) {
    /** The newest snapshot, as soon as the agent has taken in the snapshot before: see `argo.perception.HandOver`. */
    FRESH("fresh"),

    /** Each snapshot, in its order, even if the agent has not finished the work of earlier ones. */
    EVERY("every"),

    /**
     * The request is made and awaited inside the reasoning cycle and commands are written at once, as published at EMAS 2016.
     * For experiments: such an agent falls behind the world.
     */
    IN_CYCLE("in_cycle");

    companion object {
        /** Returns the policy called [word], or null. */
        fun of(word: String): SensingPolicy? = entries.find { it.word == word }

        /** The words of all policies, for a message. */
        val words: String get() = entries.joinToString(", ") { it.word }
    }
}
