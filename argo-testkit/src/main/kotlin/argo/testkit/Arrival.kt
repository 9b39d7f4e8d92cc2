package argo.testkit

import kotlin.time.Duration

/**
 * A command that has arrived at a board.
 *
 * @property command the command, as the agent has sent it
 * @property at the virtual time since the test began at which the board took it up
 */
data class Arrival(val command: String, val at: Duration)
