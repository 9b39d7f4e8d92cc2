package experiment

import kotlinx.serialization.Serializable

/**
 * What all runs of an experiment have in common. A continued experiment must have the same.
 *
 * @property seed where the order of the runs and the noise of the sensors start from
 * @property slowdown how many times slower than this computer the agents reason
 * @property computer the calibration that [slowdown] comes from, in words
 * @property port the port of a real robot, null for simulated ones
 */
@Serializable
internal data class Settings(val plan: Plan, val seed: Long, val slowdown: Double, val computer: String, val port: String? = null)
