package argo.filters

/**
 * Offers filters to agents by name.
 *
 * A project with filters in Kotlin implements this interface, and names the class in `META-INF/services/argo.filters.FilterProvider`. The
 * class needs a public constructor without arguments, since [argo.filters.format.FilterFinder] loads it with `java.util.ServiceLoader`.
 *
 * ```kotlin
 * class RobotFilters : FilterProvider {
 *     override val filters = listOf(frontDistance, nearFront)
 * }
 * ```
 */
interface FilterProvider {
    /** The filters; an agent asks for one by its [PerceptionFilter.name]. */
    val filters: Collection<PerceptionFilter>
}
