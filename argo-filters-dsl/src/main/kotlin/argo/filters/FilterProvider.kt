package argo.filters

/**
 * Offers filters to agents by name.
 *
 * A project with filters in Kotlin implements this interface, and names the class in `META-INF/services/argo.filters.FilterProvider`.
 * [argo.filters.format.FilterFinder] loads the class with `java.util.ServiceLoader`. The class therefore needs a public constructor
 * without arguments.
 *
 * ```kotlin
 * class RobotFilters : FilterProvider {
 *     override val filters = listOf(frontDistance, nearFront)
 * }
 * ```
 */
interface FilterProvider {
    /** The filters. An agent asks for a filter by its [PerceptionFilter.name]. */
    val filters: Collection<PerceptionFilter>
}
