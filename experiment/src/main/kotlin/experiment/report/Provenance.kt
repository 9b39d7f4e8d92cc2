package experiment.report

import java.time.Instant
import java.time.temporal.ChronoUnit

/**
 * What a report was made by, and when.
 *
 * @property build the version and the commit of ARGO, in words
 * @property at when the report was made
 * @property machine what the runs were made on, in words
 */
internal class Provenance(val build: String, val at: Instant, val machine: String) {
    /** The first two as a sentence. */
    val sentence: String get() = "Made with ARGO $build on ${at.truncatedTo(ChronoUnit.MINUTES)}."
}
