package argo.acting

import argo.filters.Predicate

/** Returns true if [name] is an atom for both Jason and boards: a lower-case letter followed by letters, digits and `_`. */
internal fun isPlainName(name: String): Boolean = PLAIN.matches(name)

/** Returns true if a board's rule can contain [predicate]. Boards know neither quotes nor namespaces. */
internal fun isPlain(predicate: Predicate): Boolean = predicate.namespace == Predicate.DEFAULT_NAMESPACE && isPlainName(predicate.functor)

private val PLAIN = Regex("[a-z][A-Za-z0-9_]*")
