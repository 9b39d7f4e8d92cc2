package samples.board

/** The behaviour of a simulated board's firmware: percepts and actions. Only the board's thread calls it. */
interface Sketch {
    /** Its actions, all without arguments; empty: it does not describe them. */
    val actions: List<String> get() = emptyList()

    /** Returns the percepts now, as the board sends them: each followed by `;`, of at most 255 bytes. */
    fun percepts(): String

    /** Returns the percepts now, for the rules on the board; called every few milliseconds while there are rules. */
    fun sensors(): String = percepts()

    /** Executes [command], the text that the agent sent. An unknown command changes nothing. */
    fun act(command: String)
}
