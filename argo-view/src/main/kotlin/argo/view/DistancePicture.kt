package argo.view

/**
 * A picture of something in front of a wall, drawn to scale at the top of an agent's view.
 *
 * @property distance how far it is from the wall, in [unit]; null: not known
 * @property limit the distance at which it is to stop, drawn as a line; null: none
 * @property range the longest distance that the picture has room for, in [unit], above 0
 * @property unit what distances are counted in, such as `cm`
 * @property doing what it does, in a word or two, such as `driving`
 */
data class DistancePicture(val distance: Double?, val limit: Double?, val range: Double, val unit: String, val doing: String) {
    init {
        require(range > 0 && range.isFinite()) { "the picture's range is a number above 0, not $range" }
    }
}
