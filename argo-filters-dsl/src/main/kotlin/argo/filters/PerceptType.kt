package argo.filters

import kotlin.reflect.KProperty

/** The rule under construction on this thread, if its percept type is declared. */
private val underConstruction = ThreadLocal<RuleConditions?>()

/** Calls [say], a block of conditions of the [rule] under construction. The rule records each declared argument that [say] reads. */
internal fun speakingOf(rule: RuleConditions, say: () -> Unit) {
    val outer = underConstruction.get()
    underConstruction.set(rule)
    try {
        say()
    } finally {
        underConstruction.set(outer)
    }
}

/**
 * A kind of percepts. Declares the names and types of its arguments in order.
 *
 * ```kotlin
 * object Distance : PerceptType("distance") {
 *     val side by atom()      // argument 0
 *     val cm by number()      // argument 1
 * }
 * ```
 *
 * The compiler checks conditions on declared arguments: `side gt 3` does not compile. A rule that names an argument without a condition,
 * such as `drop(Distance) { side }`, is refused at run time.
 *
 * @param predicate the functor, such as `distance` or `~open`
 * @throws IllegalArgumentException if [predicate] is no predicate
 */
@FilterDsl
abstract class PerceptType(predicate: String) {
    /** The predicate of this type's percepts. */
    val predicate: Predicate = Predicate.of(predicate)

    private var declared = 0

    /** Declares the next argument as an atom. */
    protected fun atom(): Declared<AtomArgument> = declare { index, name -> AtomArgument(this, index, name) }

    /** Declares the next argument as a number. */
    protected fun number(): Declared<NumberArgument> = declare { index, name -> NumberArgument(this, index, name) }

    /** Declares the next argument as a string. */
    protected fun string(): Declared<StringArgument> = declare { index, name -> StringArgument(this, index, name) }

    /** Declares the next argument as any term: a structure, a list, or a term of changing type. */
    protected fun term(): Declared<TermArgument> = declare { index, name -> TermArgument(this, index, name) }

    private fun <A : TypedArgument<*>> declare(make: (Int, String) -> A): Declared<A> {
        val index = declared++
        return Declared { name -> make(index, name) }
    }
}

/** The declaration of an argument, as the delegate of a property. */
class Declared<A : TypedArgument<*>> internal constructor(private val make: (name: String) -> A) {
    /** Returns the declared argument. If a rule is under construction, the rule must then get a condition on this argument. */
    operator fun getValue(type: PerceptType, property: KProperty<*>): A =
        make(property.name).also { argument -> underConstruction.get()?.mention(argument) }
}

/**
 * An argument of a [PerceptType].
 *
 * @param V the type of the values in conditions on the argument
 * @property index the argument's position, counted from 0
 */
sealed class TypedArgument<V>(
    internal val type: PerceptType,
    val index: Int,
    private val name: String,
    internal val termOf: (V) -> GroundTerm,
) {
    override fun toString(): String = name
}

/** An argument that is an atom. Conditions compare the argument with an atom in Jason's syntax, and refuse other text. */
class AtomArgument internal constructor(type: PerceptType, index: Int, name: String) : TypedArgument<String>(type, index, name, ::atomOf)

/** An argument that is a number. */
class NumberArgument internal constructor(type: PerceptType, index: Int, name: String) :
    TypedArgument<Number>(type, index, name, Number::asTerm)

/** An argument that is a string. Conditions compare the argument with a text without quotes. */
class StringArgument internal constructor(type: PerceptType, index: Int, name: String) :
    TypedArgument<String>(type, index, name, GroundTerm::Text)

/** An argument that is any term. Conditions compare the argument with a term in Jason's syntax. */
class TermArgument internal constructor(type: PerceptType, index: Int, name: String) :
    TypedArgument<String>(type, index, name, GroundTerm::of)

private fun atomOf(written: String): GroundTerm {
    val term = GroundTerm.of(written)
    require(term is GroundTerm.Structure && term.arguments.isEmpty() && term.annotations.isEmpty()) {
        "'$written' is not an atom, which the argument is declared to be"
    }
    return term
}
