package samples.board

/** What a simulated board's firmware does, in the two words that boards know. Called by the board's thread alone. */
interface Sketch {
    /** The percepts now, as the board sends them: each followed by `;`, of at most 255 bytes. */
    fun percepts(): String

    /** Does what [command] says, the text that the agent sent. A command that the board does not know changes nothing. */
    fun act(command: String)
}
