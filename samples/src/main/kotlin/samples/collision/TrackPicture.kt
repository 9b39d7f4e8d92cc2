package samples.collision

import argo.view.Picture
import kotlin.math.roundToInt

/**
 * The robot on its track, to scale.
 *
 * @property distance the distance of the robot's front from the wall in cm, or null if it is not known
 * @property limit the distance from the wall at which the robot should stop, in cm
 * @property range the length of the track in the picture in cm, above 0
 * @property doing the robot's state, such as `driving`
 */
internal data class TrackPicture(val distance: Double?, val limit: Int, val range: Double, val doing: String) {
    /**
     * Draws the track for the live view, with [caption] below it. If [caption] is null, the caption is the distance and the robot's state.
     */
    fun drawn(caption: String?) = Picture(svg(), caption ?: "${distance?.let { "${cm(it)} cm" } ?: "no distance yet"} – $doing")

    /** Draws the track as [CELLS] characters for a terminal: `o=o>` is the robot, `:` the limit and `|` the wall. */
    fun line(): String {
        val floor = CharArray(CELLS) { '_' }
        floor[cell(limit.toDouble())] = ':'
        distance?.let { ONE_LINE_ROBOT.toCharArray(floor, cell(it) + 1 - ONE_LINE_ROBOT.length) }
        return floor.concatToString() + '|'
    }

    private fun cell(distance: Double): Int {
        val first = ONE_LINE_ROBOT.length - 1 // the front of a robot at the left edge
        return first + ((CELLS - 1 - first) * (1 - share(distance))).roundToInt()
    }

    /** Draws the SVG. Without a `viewBox`, it is as wide as the page. Percentages refer to that width, and letters keep their size. */
    private fun svg(stop: Double = place(limit.toDouble())) = """
        <svg xmlns="http://www.w3.org/2000/svg" font-family="system-ui, sans-serif" font-size="13">
          <style>
            .robot { fill: #14655c } .wheel { fill: #1d2320; stroke: #fff; stroke-width: 4 } .eye { fill: #fff }
            .wall { fill: #56605a } .floor { fill: #dcdfd8 } .range { fill: #56605a } .limit { fill: #a3262a } line { stroke: #a3262a }
            @media (prefers-color-scheme: dark) {
              .robot { fill: #74d0c2 } .wheel { fill: #e8ece9; stroke: #1d2320 } .eye { fill: #1d2320 }
              .wall { fill: #a5b0aa } .floor { fill: #343c38 } .range { fill: #a5b0aa } .limit { fill: #ff9d98 } line { stroke: #ff9d98 }
            }
          </style>
          <rect class="floor" y="76" width="100%" height="3"/>
          <rect class="wall" x="$WALL%" width="${100 - WALL}%" height="82"/>
          <line x1="$stop%" x2="$stop%" y2="82" stroke-width="3" stroke-dasharray="8 4"/>
          ${distance?.let(::robot).orEmpty()}
          <text class="range" y="100">${range.toInt()} cm from the wall</text>
          <text class="limit" x="100%" y="100" text-anchor="end">to stop at $limit cm</text>
        </svg>
    """.trimIndent()

    private fun robot(distance: Double) = """
        <svg x="${place(distance) - ROBOT}%" y="12" width="$ROBOT%" height="64" viewBox="0 0 88 62" preserveAspectRatio="xMaxYMax">
          <rect class="robot" x="2" y="2" width="86" height="44" rx="9"/><rect class="eye" x="74" y="14" width="8" height="13" rx="3"/>
          <circle class="wheel" cx="22" cy="48" r="12"/><circle class="wheel" cx="66" cy="48" r="12"/>
        </svg>
    """.trimIndent()

    private fun place(distance: Double) = ROBOT + (WALL - ROBOT) * (1 - share(distance))

    private fun share(distance: Double) = (distance / range).coerceIn(0.0, 1.0)

    private companion object {
        const val WALL = 98.0

        const val ROBOT = 20.0
        const val ONE_LINE_ROBOT = "o=o>"
        const val CELLS = 36
    }
}
