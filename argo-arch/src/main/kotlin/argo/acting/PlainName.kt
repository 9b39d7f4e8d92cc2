package argo.acting

import argo.filters.Predicate

/**
 * Returns true if [name] is an atom without quotes and dots, the same to Jason and a board: a lower-case letter, then letters, digits and
 * `_`.
 */
internal fun isPlainName(name: String): Boolean = PLAIN.matches(name)

/** Returns true if a board can name [predicate] too: boards know neither quotes nor namespaces. */
internal fun isPlain(predicate: Predicate): Boolean = predicate.namespace == Predicate.DEFAULT_NAMESPACE && isPlainName(predicate.functor)

private val PLAIN = Regex("[a-z][A-Za-z0-9_]*")
