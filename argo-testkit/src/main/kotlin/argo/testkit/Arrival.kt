package argo.testkit

import kotlin.time.Duration

/** A [command] that a board took up at the virtual time [at] since the test began. */
data class Arrival(val command: String, val at: Duration)
