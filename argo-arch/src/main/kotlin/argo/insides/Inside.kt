package argo.insides

import java.lang.reflect.Field

/**
 * A private field of Jason's, of objects of [owner], called by one of [names], of which each version of Jason has one. In another version
 * it may not be there: then [get] and [set] throw a [LinkageError] that names it.
 */
class Inside<T> internal constructor(private val owner: () -> Class<*>, private vararg val names: String) {
    private val member: Field by lazy {
        val there = owner().declaredFields.find { it.name in names } ?: throw LinkageError("this version of Jason has no $this")
        there.apply { isAccessible = true }
    }

    /** Whether this version of Jason has it. */
    val isThere: Boolean get() = try {
        member.name in names
    } catch (_: LinkageError) {
        false
    }

    /** Its value in [one]; null: in the class. */
    @Suppress("UNCHECKED_CAST")
    operator fun get(one: Any?): T = member.get(one) as T

    /** Gives it this [value] in [one]; null: in the class. */
    operator fun set(one: Any?, value: T) = member.set(one, value)

    override fun toString() = try {
        "${owner().name}.${names.first()}"
    } catch (_: LinkageError) {
        names.first()
    }
}

/** What [find] finds in Jason, which is called [name]. Throws a [LinkageError] if this version has none. */
internal fun <T> inside(name: String, find: () -> T): T = try {
    find()
} catch (missing: ReflectiveOperationException) {
    throw LinkageError("this version of Jason has no $name", missing)
}
