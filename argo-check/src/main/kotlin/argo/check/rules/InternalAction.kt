package argo.check.rules

/** The names of Jason's and ARGO's internal actions, as programs write them: `.print`, `argo.act`. */
val INTERNAL_ACTION_NAMES: Set<String> get() = InternalAction.ALL.keys

/**
 * The arguments of an internal action. [kinds] are the kinds of its first arguments: `f` a formula, `l` a list, `n` a number, `s` a string,
 * `e` a list or a string, `t` a term in braces, `p` a performative, `v` a variable, `a` an atom, `d` no formula, `_` anything.
 */
internal class InternalAction(val name: String, val arities: IntRange, val kinds: List<Char>, val since: String?) {
    /** The numbers of arguments in words, such as `3 to 5 arguments`. */
    val takes: String get() = when {
        arities.last == Int.MAX_VALUE -> "${arities.first} arguments or more"
        arities.first == arities.last -> if (arities.first == 1) "1 argument" else "${arities.first} arguments"
        else -> "${arities.first} to ${arities.last} arguments"
    }

    companion object {
        /** Jason's and ARGO's internal actions, by their names in a program. */
        val ALL: Map<String, InternalAction> by lazy {
            val text = InternalAction::class.java.getResource("internal-actions.txt")!!.readText()
            text.lines().filter { it.isNotBlank() && !it.startsWith("#") }.map(::parse).associateBy { it.name }
        }

        private fun parse(line: String): InternalAction {
            val parts = line.split(' ')
            val last = if (parts[2] == "*") Int.MAX_VALUE else parts[2].toInt()
            val kinds = parts.drop(3).filter { it.length == 1 }.map(String::single)
            return InternalAction(parts[0], parts[1].toInt()..last, kinds, parts.last().substringAfter("since=", "").ifEmpty { null })
        }
    }
}
