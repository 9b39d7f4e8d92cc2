package argo.recording.recorder

import argo.Arch
import argo.boundary.Transparent
import jason.architecture.AgArch
import jason.asSemantics.TransitionSystem
import jason.infra.local.LocalAgArch
import jason.infra.local.LocalAgArchAsynchronous

/** Why the agent of [ts] cannot be recorded, for a person; null: it can. */
internal fun refusal(ts: TransitionSystem): String? {
    val architectures = generateSequence(ts.agArch) { it.nextAgArch }.toList()
    val infrastructure = architectures.last()
    val strange = architectures.filter { it !is Arch && it !is Transparent && it !== infrastructure && it.javaClass != AgArch::class.java }
    return when {
        infrastructure is LocalAgArchAsynchronous ->
            "the agent has a thread each for sensing, deliberating and acting, and what these do at once cannot be repeated; " +
                "leave out \"asynchronous\" in the .mas2j"
        infrastructure is LocalAgArch && infrastructure.runsPartsSeveralTimes() ->
            "the agent senses, deliberates or acts several times in a cycle, which a recording does not know; leave that out in the .mas2j"
        strange.isNotEmpty() ->
            "besides argo.Arch the agent has the architecture ${strange.joinToString { it.javaClass.name }}, " +
                "through which more may enter it; a recording knows argo.Arch alone"
        else -> null
    }
}

private fun LocalAgArch.runsPartsSeveralTimes() = cyclesSense != 1 || cyclesDeliberate != 1 || cyclesAct != 1
