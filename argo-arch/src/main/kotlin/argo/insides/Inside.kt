package argo.insides

import java.lang.reflect.Field

/**
 * A private field in Jason's class [owner]. Each known version of Jason has the field under one of [names]. If the field is missing in
 * another version, [get] and [set] throw a [LinkageError] with the field's name.
 */
class Inside<T> internal constructor(private val owner: () -> Class<*>, private vararg val names: String) {
    private val member: Field by lazy {
        val there = owner().declaredFields.find { it.name in names } ?: throw LinkageError("this version of Jason has no $this")
        there.apply { isAccessible = true }
    }

    /** True if this version of Jason has the field. */
    val isThere: Boolean get() = try {
        member.name in names
    } catch (_: LinkageError) {
        false
    }

    /** Returns the field's value in [one]. For a static field, [one] is null. */
    @Suppress("UNCHECKED_CAST")
    operator fun get(one: Any?): T = member.get(one) as T

    /** Sets the field in [one] to [value]. For a static field, [one] is null. */
    operator fun set(one: Any?, value: T) = member.set(one, value)

    override fun toString() = try {
        "${owner().name}.${names.first()}"
    } catch (_: LinkageError) {
        names.first()
    }
}

/** Returns the member of Jason that [find] finds. If this version of Jason lacks the member, throws a [LinkageError] with [name]. */
internal fun <T> inside(name: String, find: () -> T): T = try {
    find()
} catch (missing: ReflectiveOperationException) {
    throw LinkageError("this version of Jason has no $name", missing)
}
