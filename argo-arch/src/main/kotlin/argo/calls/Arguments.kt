package argo.calls

import jason.asSyntax.ListTerm
import jason.asSyntax.Literal
import jason.asSyntax.NumberTerm
import jason.asSyntax.Term

/** Reports that an internal action cannot use an argument. [message] names the argument, and says what the action expects. */
internal class ArgumentException(message: String) : Exception(message)

/**
 * Returns the options in [list]. Throws [ArgumentException] if [list] is not a complete list, but for example a variable or a list with an
 * open end. The message contains [example].
 */
internal fun optionsIn(list: Term, example: String): List<Term> =
    (list as? ListTerm)?.takeIf { it.isList && it.tail == null }?.asList
        ?: throw ArgumentException("the second argument is a list of options such as $example, not $list")

/**
 * Applies each option in [list] to [start] and returns the result.
 *
 * @param example a correct list, for the message
 * @param known the known options, for the message
 * @param with applies an option; returns null if the option is unknown
 * @throws ArgumentException like [optionsIn], or if any option cannot be used; the message names all unusable options
 */
internal fun <T : Any> withOptions(start: T, list: Term, example: String, known: String, with: T.(Term) -> T?): T {
    val wrong = ArrayList<String>()
    val given = HashSet<String>()
    var isUnknown = false
    val options = optionsIn(list, example).fold(start) { options, option ->
        val changed = try {
            if (option is Literal && !given.add(option.functor)) throw ArgumentException("$option is a second ${option.functor}")
            options.with(option).also { if (it == null) wrong += "$option is not an option" }
        } catch (unusable: ArgumentException) {
            wrong += unusable.message.orEmpty()
            options
        }
        isUnknown = isUnknown || changed == null
        changed ?: options
    }
    if (wrong.isNotEmpty()) throw ArgumentException(wrong.joinToString("; ") + if (isUnknown) "; there are $known" else "")
    return options
}

/** Returns the argument of [option]. Throws [ArgumentException] if the argument is no whole number in [range]. */
internal fun whole(option: Literal, range: IntRange): Int = wholeNumber(option.getTerm(0))?.takeIf { it in range }
    ?: throw ArgumentException("$option: ${option.functor} takes a whole number from ${range.first} to ${range.last}")

/** Returns [term] as a whole number; null if it is not a whole number. */
internal fun wholeNumber(term: Term): Int? {
    val value = (term as? NumberTerm)?.takeIf { it.isNumeric && it.isGround }?.solve() ?: return null
    return value.toInt().takeIf { it.toDouble() == value }
}
