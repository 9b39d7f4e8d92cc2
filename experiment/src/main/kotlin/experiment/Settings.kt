package experiment

import kotlinx.serialization.Serializable

/**
 * The settings of all runs of an experiment. A continued experiment must have the same.
 *
 * @property seed the seed of the order of the runs and of the noise of the sensors
 * @property slowdown the factor by which the agents reason more slowly than this computer
 * @property computer the calibration behind [slowdown], in words
 * @property port the port of a real robot, null for simulated ones
 */
@Serializable
internal data class Settings(val plan: Plan, val seed: Long, val slowdown: Double, val computer: String, val port: String? = null)
