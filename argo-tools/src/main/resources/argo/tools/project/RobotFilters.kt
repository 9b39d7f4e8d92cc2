import argo.filters.*

/** `dist(Side, Cm)`: the distance from one side of the robot to the next thing. */
object Dist : PerceptType("dist") {
    /** `front`, `back`, `left` or `right`. */
    val side by atom()

    /** Centimetres. */
    val cm by number()
}

/** Lets the robot see what is in front of it, and nothing else. */
val frontOnly = keepFilter("frontOnly") {
    keep(Dist) { side eq "front" }
}

/** Offers the filters to agents by their names: `argo.change_filter(frontOnly)`. */
class RobotFilters : FilterProvider {
    override val filters = listOf(frontOnly)
}
