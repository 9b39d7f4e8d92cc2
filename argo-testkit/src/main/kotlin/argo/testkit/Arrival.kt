package argo.testkit

import kotlin.time.Duration

/** A [command] that arrived at a board. [at] is the virtual time since the start of the test. */
data class Arrival(val command: String, val at: Duration)
