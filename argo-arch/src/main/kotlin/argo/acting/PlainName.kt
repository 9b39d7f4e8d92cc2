package argo.acting

import argo.filters.Predicate

/**
 * Returns true if [name] is a lower-case letter, then letters, digits and `_`: an atom to Jason and to a board, without quotes and dots.
 */
internal fun isPlainName(name: String): Boolean = PLAIN.matches(name)

/** Returns true if a board can name [predicate] too: boards know neither quotes nor namespaces. */
internal fun isPlain(predicate: Predicate): Boolean = predicate.namespace == Predicate.DEFAULT_NAMESPACE && isPlainName(predicate.functor)

private val PLAIN = Regex("[a-z][A-Za-z0-9_]*")
