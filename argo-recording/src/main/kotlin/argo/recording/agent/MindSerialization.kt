package argo.recording.agent

import jason.asSemantics.Agent
import jason.asSemantics.ArithFunction
import jason.asSemantics.InternalAction
import jason.asSyntax.DefaultTerm
import jason.asSyntax.ObjectTermImpl
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.InvalidClassException
import java.io.NotSerializableException
import java.io.ObjectInputFilter
import java.io.ObjectInputStream
import java.io.ObjectOutputStream
import java.io.ObjectStreamClass
import java.io.OutputStream
import java.io.Serializable
import java.lang.reflect.Method

private class PartReference(val number: Int) : Serializable

private class ActionReference(val type: String) : Serializable

private class FunctionReference(val name: String) : Serializable

private class AgentReference : Serializable

/**
 * Returns [mind] in bytes, with references to the parts of [program].
 *
 * @throws NotSerializableException if [mind] contains a Java object that cannot be written
 */
internal fun bytesOf(mind: Mind, program: ProgramParts): ByteArray =
    ByteArrayOutputStream().also { bytes -> MindOutput(bytes, program).use { it.writeObject(mind) } }.toByteArray()

/**
 * Reads the mind that [bytesOf] wrote, for the agent of [code]. The mind's intentions get the plans of [program].
 *
 * @throws java.io.IOException if [bytes] are something else, or come from another version of Jason
 */
internal fun mindOf(bytes: ByteArray, program: ProgramParts, code: WatchedCode): Mind = try {
    MindInput(bytes, program, code).use { it.readObject() as Mind }
} catch (refused: InvalidClassException) {
    throw refused.cause?.let { InvalidClassException("${it.message}") } ?: refused // the filter's own reason is in the cause
} catch (missing: ClassNotFoundException) {
    throw InvalidClassException("class ${missing.message} is missing")
} catch (other: RuntimeException) { // the objects do not fit together
    throw InvalidClassException("$other")
}

private class MindOutput(bytes: OutputStream, private val program: ProgramParts) : ObjectOutputStream(bytes) {
    init {
        enableReplaceObject(true)
    }

    override fun replaceObject(one: Any): Any? = when {
        one === program.agent -> AgentReference()
        one is InternalAction -> ActionReference(one.javaClass.name)
        one is ArithFunction -> FunctionReference(one.name)
        one is Throwable -> null // if writing fails, Java writes the exception
        one is Method -> null // an object term caches a method of its object
        ProgramParts.mayBePart(one) -> program.numberOf(one)?.let(::PartReference) ?: allowed(one)
        else -> allowed(one)
    }

    private fun allowed(one: Any) = one.also {
        if (one is Serializable && isAllowed(one.javaClass)) return@also
        throw NotSerializableException(
            if (one is Iterator<*>) "a loop \"for\" went through beliefs"
            else "an intention held an object of the class ${one.javaClass.name}",
        )
    }
}

private class MindInput(bytes: ByteArray, private val program: ProgramParts, private val code: WatchedCode) :
    ObjectInputStream(ByteArrayInputStream(bytes)) {
    private val size = bytes.size.toLong()
    private var elements = 0L // elements of all arrays so far
    private var replacement: Class<*>? = null // class of the last object that replaced a reference; the filter also sees it

    init {
        enableResolveObject(true)
        objectInputFilter = ObjectInputFilter { info ->
            if (info.arrayLength() > 0) elements += info.arrayLength()
            if (info.serialClass() != null && info.serialClass() === replacement) {
                replacement = null
                return@ObjectInputFilter ObjectInputFilter.Status.UNDECIDED
            }
            val refusal = refusal(info)
            if (refusal != null) throw IllegalArgumentException(refusal)
            ObjectInputFilter.Status.UNDECIDED
        }
    }

    /**
     * Returns the reason to refuse an object; null if it is allowed. Since the recording may come from an untrusted person, only terms and
     * intentions are allowed, and no more than the bytes can describe.
     */
    private fun refusal(info: ObjectInputFilter.FilterInfo): String? = when {
        info.serialClass()?.let(::isAllowed) == false -> "it has an object of the class ${info.serialClass().name}"
        info.depth() > MAX_DEPTH -> "its objects are nested more than $MAX_DEPTH deep"
        info.references() > size || elements > size * MAX_ELEMENTS_OF_BYTE -> "it claims more objects than its $size bytes can hold"
        else -> null
    }

    override fun resolveClass(description: ObjectStreamClass): Class<*> =
        Class.forName(description.name, false, MindInput::class.java.classLoader)

    override fun resolveObject(one: Any): Any = resolved(one).also { if (it !== one) replacement = it.javaClass }

    private fun resolved(one: Any): Any = when (one) {
        is AgentReference -> code.agent
        is PartReference -> program.part(one.number)
        is ActionReference -> code.action(one.type)
        is FunctionReference -> code.function(one.name)
        is ObjectTermImpl -> ObjectTermImpl(one.`object`)
        is DefaultTerm -> one.apply { resetHashCodeCache() } // hashes of constants differ between programs
        else -> one
    }
}

internal const val MAX_MIND_BYTES = 16 * 1024 * 1024

/** The deepest nesting of objects. Each element of a Jason list is nested within the element before it. */
private const val MAX_DEPTH = 10_000L

/** The largest number of array elements for each byte. A hash table has up to eight slots for each entry. */
private const val MAX_ELEMENTS_OF_BYTE = 16

private val OWN = setOf(
    Mind::class.java, Wait::class.java, PartReference::class.java, ActionReference::class.java, FunctionReference::class.java,
    AgentReference::class.java,
)

private val PACKAGES = setOf("jason.asSyntax", "jason.asSemantics")

private val ALLOWED_OF_JAVA = setOf(
    "java.util.ArrayList", "java.util.LinkedList", "java.util.ArrayDeque", "java.util.HashMap", "java.util.LinkedHashMap",
    "java.util.HashSet", "java.util.LinkedHashSet", "java.util.Map\$Entry", "java.lang.String", "java.lang.Integer", "java.lang.Long",
    "java.lang.Double", "java.lang.Boolean", "java.lang.Number", "java.lang.Enum", "java.lang.Object",
)

/** Returns true if objects of [type] may occur in a recording, since they are terms or parts of intentions. */
private fun isAllowed(type: Class<*>): Boolean = when {
    type.isPrimitive -> true
    type.isArray -> isAllowed(type.componentType)
    type in OWN || type.name in ALLOWED_OF_JAVA -> true
    type.name.startsWith("jason.stdlib.fork$") -> true
    CODE.any { it.isAssignableFrom(type) } -> false // a recording has only references to code
    else -> type.packageName in PACKAGES && type.name !in REFUSED
}

private val CODE = listOf(InternalAction::class.java, ArithFunction::class.java, Agent::class.java)

/** Classes of objects that belong to one run of an agent. */
private val REFUSED = setOf("jason.asSemantics.TransitionSystem", "jason.asSemantics.Circumstance", "jason.asSemantics.Agent")
