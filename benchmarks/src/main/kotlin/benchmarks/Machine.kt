package benchmarks

/** The machine that a figure was measured on, in a few words. */
fun machine(): String =
    "${Runtime.getRuntime().availableProcessors()} processors, Java ${Runtime.version().feature()}, ${System.getProperty("os.name")} " +
        "${System.getProperty("os.arch")}"
