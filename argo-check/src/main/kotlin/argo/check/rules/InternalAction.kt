package argo.check.rules

import argo.check.syntax.Literal

/** The names of Jason's and ARGO's internal actions as programs write them, such as `.print` and `argo.act`. */
val INTERNAL_ACTION_NAMES: Set<String> get() = InternalAction.ALL.keys

/**
 * An internal action and its arguments.
 *
 * @property kinds the kinds of its first arguments: a key of [WORDS], `p` for a performative, or `_` for anything
 * @property inputs the indices, counted from 0, of the arguments that must have a value
 */
internal class InternalAction(val name: String, val arities: IntRange, val kinds: List<Char>, val inputs: Set<Int>, val since: String?) {
    /** The accepted numbers of arguments in words, such as `3 to 5 arguments`. */
    val takes: String get() = when {
        arities.last == Int.MAX_VALUE -> "${arities.first} arguments or more"
        arities.first == arities.last -> if (arities.first == 1) "1 argument" else "${arities.first} arguments"
        else -> "${arities.first} to ${arities.last} arguments"
    }

    companion object {
        /** The words for [kinds]. */
        val WORDS = mapOf(
            'f' to "a formula", 'l' to "a list", 'n' to "a number", 's' to "a string", 'e' to "a list or a string", 'v' to "a variable",
            'a' to "an atom", 'b' to "begin or end", 'd' to "a term, no formula", 't' to "a term in braces",
        )

        val ALL: Map<String, InternalAction> by lazy {
            val text = InternalAction::class.java.getResource("internal-actions.txt")!!.readText()
            text.lines().filter { it.isNotBlank() && !it.startsWith("#") }.map(::parse).associateBy { it.name }
        }

        /** CArtAgO operations in which strings name artifacts and Java classes. */
        private val OPERATIONS: Map<String, InternalAction> =
            listOf("makeArtifact 2 4 S s", "lookupArtifact 2 2 S v").map(::parse).associateBy { it.name }

        /** Returns the internal action or CArtAgO operation of [call], or null if it is another call. */
        fun of(call: Literal): InternalAction? =
            if (call.isInternal) ALL[call.functor] else OPERATIONS[call.functor]?.takeIf { call.arity in it.arities }

        /** Jason's arithmetic functions. */
        val FUNCTIONS = setOf(
            "math.abs", "math.acos", "math.asin", "math.atan", "math.average", "math.ceil", "math.cos", "math.e", "math.floor", "math.log",
            "math.max", "math.mean", "math.median", "math.min", "math.pi", "math.random", "math.round", "math.sin", "math.sqrt",
            "math.std_dev", "math.sum", "math.tan", "system.time", ".length",
        )

        private fun parse(line: String): InternalAction {
            val parts = line.split(' ')
            val last = if (parts[2] == "*") Int.MAX_VALUE else parts[2].toInt()
            val kinds = parts.drop(3).filter { it.length == 1 }.map(String::single)
            val inputs = kinds.indices.filter { kinds[it].isUpperCase() }.toSet()
            val since = parts.last().substringAfter("since=", "").ifEmpty { null }
            return InternalAction(parts[0], parts[1].toInt()..last, kinds.map(Char::lowercaseChar), inputs, since)
        }
    }
}
