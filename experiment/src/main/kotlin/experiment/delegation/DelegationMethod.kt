package experiment.delegation

import experiment.MAX_TRIES
import experiment.Settings
import experiment.report.Provenance
import experiment.report.escaped
import experiment.report.method
import experiment.report.one
import experiment.report.whole

/** Describes the method of the experiment as items of an HTML list. Uses its [settings] and its [measured] runs. */
internal fun method(settings: Settings<DelegationPlan>, measured: List<Measured>, made: Provenance): String {
    val plan = settings.plan
    return method(
        DESIGN + listOf(
            "Load" to "all readings change with each message. ${plan.sensors.joinToString()} sensors, a third of each kind; " +
                "${plan.plans.joinToString()} plans a percept, of which all but the last ask a belief and do not apply; intervals of " +
                "${plan.intervals.joinToString()} ms.",
            "Computer" to "the reasoning of the agents, not their sensing threads, is slowed ${settings.slowdown} times: " +
                "${escaped(settings.computer)}. A reasoning cycle holds one of ${plan.processors.joinToString(" or ")} processors, and " +
                "takes the processor time that it takes here, times the slowdown. So this machine, which is idle most of the time, " +
                "stands for computers with more processors and fewer.",
            "Runs" to "${plan.blocks} blocks, each with all ${plan.loads.size * Design.entries.size} combinations once, in random order, " +
                "seed ${settings.seed}. A run is measured for ${DelegationLaboratory.MEASURED_MS} ms, after " +
                "${DelegationLaboratory.WARM_UP_MS} ms. Its reaction is the median of its reactions. ${escaped(made.machine)}",
            "Intervals" to "Student's t of the logarithms of the ratios within the blocks. One in twenty misses its ratio.",
            "Time" to "real. A thread wakes every 5 ms; its largest delay in a run was ${one(measured.maxOf { it.result.lateMs })} ms. " +
                "A run with a delay above ${whole(DelegationResult.MAX_LATE_MS)} ms was repeated, until it was made $MAX_TRIES times.",
        ),
    )
}

private val DESIGN = listOf(
    "Designs" to "<em>${Design.ONE.title}</em> with one board. <em>${Design.BOARDS.title}</em>, one for each kind of sensor. " +
        "<em>${Design.KINDS_APART.title}</em> of sensor, each an ARGO agent with a board, as in section 5.3 of the paper. " +
        "<em>${Design.DELEGATES.title}</em>: an ARGO agent tells and untells each percept to a common agent for its kind, which " +
        "asks the ARGO agent to act. The programs are in <code>experiment/agent/delegation</code>.",
    "Stimuli" to "from time to time something comes near one of the distance sensors, drawn by seed, and stays until the robot has " +
        "stopped for it, ${Stimuli.LIMIT_MS} ms at most; the next comes 50 to 150 ms later. The reaction begins when it comes, and ends " +
        "when the board carries out the command. A stimulus without a reaction counts as ${Stimuli.LIMIT_MS} ms.",
    "Boards" to "simulated, version 2 of Javino, ${Society.BAUD} baud; each byte takes its ten bit times.",
)
