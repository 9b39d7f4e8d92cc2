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

/** In the place of a part of the program. */
private class PartReference(val number: Int) : Serializable

/** In the place of an internal action; [isWatched]: [name] is that of the program, otherwise its class. */
private class ActionReference(val name: String, val isWatched: Boolean) : Serializable

/** In the place of a function; likewise. */
private class FunctionReference(val name: String, val isWatched: Boolean) : Serializable

/** In the place of the agent. */
private class AgentReference : Serializable

/**
 * [mind] in bytes; what [program] has is referred to.
 * @throws NotSerializableException if it holds a Java object that cannot be written; the message says so to a person
 */
internal fun bytesOf(mind: Mind, program: ProgramParts): ByteArray =
    ByteArrayOutputStream().also { bytes -> MindOutput(bytes, program).use { it.writeObject(mind) } }.toByteArray()

/**
 * What [bytesOf] wrote, for the agent of [code]: its intentions are of the plans of [program].
 * @throws java.io.IOException if it is something else, or was written by another version of Jason
 */
internal fun mindOf(bytes: ByteArray, program: ProgramParts, code: WatchedCode): Mind = try {
    MindInput(bytes, program, code).use { it.readObject() as Mind }
} catch (missing: ClassNotFoundException) {
    throw InvalidClassException("class ${missing.message} is missing")
} catch (other: RuntimeException) { // what stands there does not fit together
    throw InvalidClassException("$other")
}

private class MindOutput(bytes: OutputStream, private val program: ProgramParts) : ObjectOutputStream(bytes) {
    init {
        enableReplaceObject(true)
    }

    override fun replaceObject(one: Any): Any? = when {
        one === program.agent -> AgentReference()
        one is InternalAction -> WatchedCode.nameOf(one)?.let { ActionReference(it, true) } ?: ActionReference(one.javaClass.name, false)
        one is ArithFunction -> WatchedCode.nameOf(one)?.let { FunctionReference(it, true) } ?: FunctionReference(one.name, false)
        one is Throwable -> null // Java writes why it cannot write
        one is Method -> null // what an object term remembers of its object
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
    init {
        enableResolveObject(true)
        objectInputFilter = ObjectInputFilter { info ->
            val type = info.serialClass()
            if (type == null || isAllowed(type) || CODE.any { it.isAssignableFrom(type) }) ObjectInputFilter.Status.UNDECIDED
            else ObjectInputFilter.Status.REJECTED
        }
    }

    override fun resolveClass(description: ObjectStreamClass): Class<*> =
        Class.forName(description.name, false, MindInput::class.java.classLoader)

    override fun resolveObject(one: Any): Any = when (one) {
        is AgentReference -> code.agent
        is PartReference -> program.part(one.number)
        is ActionReference -> if (one.isWatched) code.watchedAction(one.name) else code.agent.getIA(one.name)
        is FunctionReference -> if (one.isWatched) code.watchedFunction(one.name) else code.function(one.name)
        is ObjectTermImpl -> ObjectTermImpl(one.`object`)
        is DefaultTerm -> one.apply { resetHashCodeCache() } // hashes of constants differ from program to program
        else -> one
    }
}

/** What references become. */
private val CODE = listOf(InternalAction::class.java, ArithFunction::class.java, Agent::class.java)

private val OWN = Mind::class.java.packageName + "."

private val ALLOWED = listOf("jason.asSyntax.", "jason.asSemantics.", "jason.stdlib.fork$", OWN)

private val ALLOWED_OF_JAVA = setOf(
    "java.util.ArrayList", "java.util.LinkedList", "java.util.ArrayDeque", "java.util.HashMap", "java.util.LinkedHashMap",
    "java.util.HashSet", "java.util.LinkedHashSet", "java.util.Map\$Entry", "java.lang.String", "java.lang.Integer", "java.lang.Long",
    "java.lang.Double", "java.lang.Boolean", "java.lang.Number", "java.lang.Enum", "java.lang.Object",
)

/** Whether objects of [type] may stand in a recording: terms, and what intentions consist of. */
private fun isAllowed(type: Class<*>): Boolean = when {
    type.isPrimitive -> true
    type.isArray -> isAllowed(type.componentType)
    else -> type.name in ALLOWED_OF_JAVA || ALLOWED.any(type.name::startsWith) && type.name !in REFUSED
}

/** What belongs to one run of an agent. */
private val REFUSED = setOf("jason.asSemantics.TransitionSystem", "jason.asSemantics.Circumstance", "jason.asSemantics.Agent")
