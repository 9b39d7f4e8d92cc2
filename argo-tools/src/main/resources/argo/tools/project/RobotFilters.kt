import argo.filters.*

/** `dist(Side, Cm)`: the distance to the nearest object on one side of the robot. */
object Dist : PerceptType("dist") {
    /** `front`, `back`, `left` or `right`. */
    val side by atom()

    /** The distance in cm. */
    val cm by number()
}

/** Keeps percepts of the front, and drops all others. */
val frontOnly = keepFilter("frontOnly") {
    keep(Dist) { side eq "front" }
}

/** Gives agents the filters by name: `argo.change_filter(frontOnly)`. */
class RobotFilters : FilterProvider {
    override val filters = listOf(frontOnly)
}
