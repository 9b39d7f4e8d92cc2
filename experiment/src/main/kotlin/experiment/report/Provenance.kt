package experiment.report

import java.time.Instant
import java.time.temporal.ChronoUnit

/**
 * The origin of a report.
 *
 * @property build the version and the commit of ARGO, in words
 * @property at the time at which the report was made
 * @property machine the machine of the runs, in words
 */
internal class Provenance(val build: String, val at: Instant, val machine: String) {
    /** The first two as a sentence. */
    val sentence: String get() = "Made with ARGO $build on ${at.truncatedTo(ChronoUnit.MINUTES)}."
}
