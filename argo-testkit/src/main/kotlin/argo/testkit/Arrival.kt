package argo.testkit

import kotlin.time.Duration

/** A [command] that arrived at a board when the virtual time [at] had passed since the test began. */
data class Arrival(val command: String, val at: Duration)
