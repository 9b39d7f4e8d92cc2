package argo.testkit

import kotlin.time.Duration

/**
 * Runs the reasoning cycles of [agent]. Each cycle takes the agent's cycle time. Virtual time advances only while the agent sleeps. The
 * number of cycles at one instant is therefore limited.
 */
internal class CycleLimit(private val agent: TestAgent) {
    private val time get() = agent.mas.time
    private var cycles = 0
    private var cyclesAt = -1L
    private var isBusy = false

    /**
     * Runs one cycle and returns true. Returns false if the agent sleeps, or if its last cycle has not ended. Fails if the agent never
     * sleeps.
     */
    fun step(): Boolean {
        if (isBusy || !reason()) return false
        takeTime()
        if (cyclesAt != time.nanos()) cycles = 0
        cyclesAt = time.nanos()
        if (++cycles < agent.mas.mostCycles) return true
        cycles = 0
        throw AssertionError(
            "agent ${agent.name} is still busy after ${agent.mas.mostCycles} cycles at one instant: a plan that repeats itself has to " +
                "wait for something, time (.wait) or a command (argo.act)\n${agent.report()}",
        )
    }

    private fun takeTime() {
        if (agent.setUp.cycleTime == Duration.ZERO) return
        isBusy = true
        time.later(nanos(agent.setUp.cycleTime)) { isBusy = false }
    }

    private fun reason(): Boolean = try {
        agent.infra.reason()
    } catch (endless: StackOverflowError) {
        throw AssertionError(
            "agent ${agent.name} calls itself without end, in a rule or an internal action; the cause shows its last calls\n" +
                agent.report(),
            endless,
        )
    }

    companion object {
        const val MOST = 10_000
    }
}
