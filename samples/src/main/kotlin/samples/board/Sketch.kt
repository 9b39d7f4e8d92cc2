package samples.board

/** What a simulated board's firmware does, in the two words that boards know. Called by the board's thread alone. */
interface Sketch {
    /** The actions that it has, none of which takes an argument; empty: it does not tell. */
    val actions: List<String> get() = emptyList()

    /** The percepts now, as the board sends them: each followed by `;`, of at most 255 bytes. */
    fun percepts(): String

    /** The percepts now, which the rules on the board are compared with; called every few milliseconds while there are some. */
    fun sensors(): String = percepts()

    /** Executes [command], the text that the agent sent. An unknown command changes nothing. */
    fun act(command: String)
}
