package argo.check.project

import argo.check.syntax.Token
import argo.check.syntax.TokenKind

/**
 * The fleet of a project file: `infrastructure: Fleet(hosts([base("10.8.0.1"), host("rasp-pi","10.8.0.2")]), insecure)`.
 *
 * @param tokens the file's tokens behind `Fleet`
 */
class MasFleet internal constructor(private val tokens: List<Token>) {
    private val begins = begins()

    /** The names of the fleet's options. */
    val options: List<Token> = begins.filter { it.depth == 1 }.map { tokens[it.at] }

    /** The names of the fleet's computers, some in quotes; empty: the file does not name them. */
    val hosts: List<Token> = begins.filter { it.depth == OF_HOSTS && it.option == "hosts" }.map { nameOf(it.at) }

    /** A token that begins an item: an argument or a part of a list, in [depth] brackets and in the [option] of the fleet. */
    private class Begin(val at: Int, val depth: Int, val option: String)

    private fun begins(): List<Begin> {
        val found = ArrayList<Begin>()
        var depth = 0
        var option = ""
        for ((at, token) in tokens.withIndex()) {
            if (at > 0 && tokens[at - 1].let { it.isOpening || it.isSymbol(",") }) {
                if (depth == 1) option = token.text
                found += Begin(at, depth, option)
            }
            if (token.isOpening) depth++ else if (token.isClosing) depth--
            if (depth == 0) break
        }
        return found
    }

    /** Returns the name of the computer that begins at [at]: that of `host("rasp-pi","10.8.0.2")` is its first argument. */
    private fun nameOf(at: Int): Token {
        val argument = tokens.getOrNull(at + 2)?.takeIf { it.kind == TokenKind.STRING }
        return argument?.takeIf { tokens[at].text == "host" && tokens.getOrNull(at + 3)?.text == "," } ?: tokens[at]
    }

    private companion object {
        /** The depth inside of `Fleet(`, `hosts(` and `[`. */
        const val OF_HOSTS = 3
    }
}
