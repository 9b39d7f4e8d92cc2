package samples

import java.util.Locale

/** Writes [distance], in cm, as the samples print it: `38.6`. */
internal fun cm(distance: Double): String = String.format(Locale.ROOT, "%.1f", distance)

/** Writes [nanos] as seconds: `4.2`. */
internal fun seconds(nanos: Long): String = String.format(Locale.ROOT, "%.1f", nanos / 1e9)
