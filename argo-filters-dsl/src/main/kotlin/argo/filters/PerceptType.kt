package argo.filters

import kotlin.reflect.KProperty

/**
 * A kind of percepts, with the names and types of its arguments in their order.
 *
 * ```kotlin
 * object Distance : PerceptType("distance") {
 *     val side by atom()      // argument 0
 *     val cm by number()      // argument 1
 * }
 * ```
 *
 * Conditions on a declared argument are checked by the compiler: `side gt 3` does not compile.
 *
 * @param predicate the functor, as in `distance` or `~open`
 * @throws IllegalArgumentException if [predicate] is none
 */
@FilterDsl
abstract class PerceptType(predicate: String) {
    /** What percepts of this type are called. */
    val predicate: Predicate = Predicate.of(predicate)

    private var declared = 0

    /** The next argument is an atom. */
    protected fun atom(): Declared<AtomArgument> = Declared(AtomArgument(declared++))

    /** The next argument is a number. */
    protected fun number(): Declared<NumberArgument> = Declared(NumberArgument(declared++))

    /** The next argument is a string. */
    protected fun string(): Declared<StringArgument> = Declared(StringArgument(declared++))

    /** The next argument is any term: a structure, a list, or now one thing and now another. */
    protected fun term(): Declared<TermArgument> = Declared(TermArgument(declared++))
}

/** The declaration of an argument, which a property is delegated to. */
class Declared<A : TypedArgument<*>> internal constructor(private val argument: A) {
    /** The argument that was declared. */
    operator fun getValue(type: PerceptType, property: KProperty<*>): A = argument
}

/**
 * An argument of a [PerceptType].
 *
 * @param V what conditions compare it with
 * @property index which it is, counted from 0
 */
sealed class TypedArgument<V>(val index: Int, internal val termOf: (V) -> GroundTerm)

/** An argument that is an atom. Conditions compare it with the text of one, as Jason writes it; other text is refused. */
class AtomArgument internal constructor(index: Int) : TypedArgument<String>(index, ::atomOf)

/** An argument that is a number. */
class NumberArgument internal constructor(index: Int) : TypedArgument<Number>(index, Number::asTerm)

/** An argument that is a string. Conditions compare it with a text without quotes. */
class StringArgument internal constructor(index: Int) : TypedArgument<String>(index, GroundTerm::Text)

/** An argument that is any term. Conditions compare it with the text of one, as Jason writes it. */
class TermArgument internal constructor(index: Int) : TypedArgument<String>(index, GroundTerm::of)

private fun atomOf(written: String): GroundTerm {
    val term = GroundTerm.of(written)
    require(term is GroundTerm.Structure && term.arguments.isEmpty() && term.annotations.isEmpty()) {
        "'$written' is not an atom, which the argument is declared to be"
    }
    return term
}
