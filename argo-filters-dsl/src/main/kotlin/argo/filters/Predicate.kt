package argo.filters

/**
 * The name of a rule or a term: a functor in Jason's syntax, negated or not, in a namespace. `open`, `~open` and `house::open` are three
 * different predicates.
 *
 * @property functor the atom as written, including quotes: `dist`, `'Left wheel'`
 * @property negated true if the functor has strong negation (`~`)
 * @property namespace the namespace's name, or [DEFAULT_NAMESPACE]
 */
data class Predicate(val functor: String, val negated: Boolean = false, val namespace: String = DEFAULT_NAMESPACE) {

    init {
        require(Syntax.isAtom(functor)) { "'$functor' is no functor: ${Syntax.FUNCTOR_IN_WORDS}" }
        require(isNamespace(namespace)) { "'$namespace' is no namespace: ${Syntax.FUNCTOR_IN_WORDS}" }
        require(isWritable(functor, negated, namespace)) { "$functor is neither negated nor in a namespace in Jason" }
    }

    /** Returns the predicate in Jason's syntax: `dist`, `~open`, `house::~open`. */
    override fun toString(): String = buildString {
        if (namespace != DEFAULT_NAMESPACE) append(namespace).append("::")
        if (negated) append('~')
        append(functor)
    }

    companion object {
        /** The namespace of a predicate without a written namespace. */
        const val DEFAULT_NAMESPACE: String = "default"

        /** Jason's word for the current namespace. */
        internal const val THIS_NAMESPACE = "this_ns"

        /**
         * Reads a predicate in Jason's syntax: `dist`, `~open`, `house::dist`.
         *
         * @throws IllegalArgumentException if [text] is no predicate; the message states the fault
         */
        fun of(text: String): Predicate {
            val separator = separator(text)
            val namespace = if (separator < 0) DEFAULT_NAMESPACE else namespaceOf(text.substring(0, separator).trim())
            val rest = (if (separator < 0) text else text.substring(separator + 2)).trim()
            val negated = rest.startsWith('~')
            return Predicate(if (negated) rest.substring(1).trimStart() else rest, negated, namespace)
        }

        /** Returns the index of the `::` after a namespace. Negative if there is none. A `::` between quotes belongs to a name. */
        private fun separator(text: String): Int {
            val first = text.indexOf("::")
            val quote = text.indexOf('\'')
            return if (quote in 0..first) text.indexOf("::", text.indexOf('\'', quote + 1)) else first
        }

        private fun isNamespace(name: String) = Syntax.isAtom(name) && name !in Syntax.TRUTH_VALUES && name != THIS_NAMESPACE

        private fun isWritable(functor: String, negated: Boolean, namespace: String) =
            functor !in Syntax.TRUTH_VALUES || !negated && namespace == DEFAULT_NAMESPACE

        /** Returns the namespace for [written], the possibly empty text before `::`. */
        internal fun namespaceOf(written: String): String =
            if (written.isEmpty() || written == THIS_NAMESPACE) DEFAULT_NAMESPACE else written
    }
}
