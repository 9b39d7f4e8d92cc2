package argo.testkit

import argo.Arch
import argo.platform.Platform

/**
 * Returns the factory of the architecture for an agent that another agent creates.
 *
 * @param classes the classes in `agentArchClass(…)`; if empty, the class of [father] is used
 * @throws IllegalArgumentException if the architecture cannot run in a test
 */
internal fun archOf(classes: List<String>, father: TestAgent?): ((Platform) -> Arch)? = when {
    classes.isEmpty() -> if (father == null) ::Arch else father.setUp.arch
    classes == listOf(Arch::class.java.name) -> ::Arch
    else -> archOf(
        requireNotNull(classes.singleOrNull()) { "an agent under test has one architecture, not ${classes.joinToString()}" },
    )
}

private fun archOf(name: String): (Platform) -> Arch {
    val constructor = try {
        Class.forName(name).asSubclass(Arch::class.java).getConstructor(Platform::class.java)
    } catch (unusable: ReflectiveOperationException) {
        throw unusable(name, unusable)
    } catch (unusable: ClassCastException) {
        throw unusable(name, unusable)
    }
    return constructor::newInstance
}

private fun unusable(name: String, cause: Exception) = IllegalArgumentException(
    "an agent under test can have the architecture argo.Arch, or a public subclass of it " +
        "whose constructor takes the platform and passes it on; $name is none",
    cause,
)
