package benchmarks

import argo.Arch
import argo.platform.Platform
import java.lang.management.ManagementFactory

/** An agent whose reasoning cycles are measured: see [times]. */
class TimedArch(platform: Platform) : Arch(platform) {
    private var begunNs = 0L

    constructor() : this(Platform.system)

    override fun reasoningCycleStarting() {
        begunNs = threads.currentThreadCpuTime
        super.reasoningCycleStarting()
    }

    override fun reasoningCycleFinished() {
        super.reasoningCycleFinished()
        times?.add(threads.currentThreadCpuTime - begunNs)
    }

    companion object {
        private val threads = ManagementFactory.getThreadMXBean()

        /**
         * Takes the processor time of the agent's thread in each cycle, in ns; null: it is not measured. Read it only when no agent runs.
         */
        @Volatile
        var times: MutableList<Long>? = null
    }
}
