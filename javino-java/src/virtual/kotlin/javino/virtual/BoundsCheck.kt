package javino.virtual

import kotlin.random.Random

/**
 * Makes at least [exchanges] exchanges in random cases, which depend only on [seed]. Returns, for each bound, the measurement that came
 * closest to it or exceeded it most.
 */
internal fun checkBounds(exchanges: Int, seed: Long): Map<Bounded, Closest> {
    val closest = LinkedHashMap<Bounded, Closest>()
    val courses = Random(seed)
    var made = 0
    while (made < exchanges) {
        val random = Random(courses.nextLong())
        val run = BoundsRun(BoundsCase.random(random), random)
        run.use { while (it.exchanges < EXCHANGES_OF_A_COURSE) it.step() }
        made += run.exchanges
        run.closest.forEach { (what, found) -> closest.merge(what, found) { one, other -> if (one.share < other.share) other else one } }
    }
    return closest
}

private const val EXCHANGES_OF_A_COURSE = 200
