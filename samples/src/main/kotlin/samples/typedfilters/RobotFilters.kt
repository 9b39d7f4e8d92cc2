package samples.typedfilters

import argo.filters.*

/** `dist(Side, Cm)`: the distance from one side of the robot to the nearest obstacle. */
object Dist : PerceptType("dist") {
    /** `f`, `b`, `r` or `l`. */
    val side by atom()

    /** The distance in cm. */
    val cm by number()
}

/** Keeps percepts of obstacles in front of the robot. */
val frontOnly = keepFilter("frontOnly") {
    keep(Dist) { side eq "f" }
}

/** Keeps percepts of obstacles in front of the robot and nearer than one metre. */
val nearFront = keepFilter("nearFront") {
    keep(Dist) {
        side eq "f"
        cm lt 100
    }
}

/** Gives agents the filters by name. */
class RobotFilters : FilterProvider {
    override val filters = listOf(frontOnly, nearFront)
}
