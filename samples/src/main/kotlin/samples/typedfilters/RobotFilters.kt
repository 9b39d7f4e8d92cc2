package samples.typedfilters

import argo.filters.*

/** `dist(Side, Cm)`: the distance from one side of the robot to the nearest obstacle. */
object Dist : PerceptType("dist") {
    /** `f`, `b`, `r` or `l`. */
    val side by atom()

    /** Centimetres. */
    val cm by number()
}

/** Keeps percepts of things in front of the robot. */
val frontOnly = keepFilter("frontOnly") {
    keep(Dist) { side eq "f" }
}

/** Keeps percepts of things in front of the robot and nearer than a metre. */
val nearFront = keepFilter("nearFront") {
    keep(Dist) {
        side eq "f"
        cm lt 100
    }
}

/** Offers the filters to agents by their names. */
class RobotFilters : FilterProvider {
    override val filters = listOf(frontOnly, nearFront)
}
