package argo.recording.recorder

import argo.Arch
import argo.boundary.Transparent
import jason.architecture.AgArch
import jason.asSemantics.Agent
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.bb.DefaultBeliefBase
import jason.infra.local.LocalAgArch
import jason.infra.local.LocalAgArchAsynchronous
import jason.util.Config

/**
 * Returns the reason, in words, why the classes and plans of the agent of [ts] cannot be recorded; null if they can. [StoredProgram]
 * refuses directives of the project. [WatchedCode][argo.recording.agent.WatchedCode] refuses unknown internal actions.
 */
internal fun refusalOfClasses(ts: TransitionSystem): String? {
    val (agent, beliefs) = ts.ag.javaClass to ts.ag.bb.javaClass
    val kqml = Config.get().kqmlPlansFile
    return when {
        agent != Agent::class.java ->
            "the agent's class ${agent.name} is not Jason's own, and the data by which it chooses and believes are not recorded"
        beliefs != DefaultBeliefBase::class.java ->
            "the belief base ${beliefs.name} is not Jason's own, and the data that it reads or keeps elsewhere are not recorded"
        isCloned() -> "it was made by .clone, so its beliefs and intentions are not those of its program"
        kqml != Message.kqmlDefaultPlans -> "the plans for messages in $kqml, which Jason's configuration names, are not recorded"
        else -> null
    }
}

/** Returns true if the calling thread is cloning an agent. Looks at the call stack, since a clone looks like any other agent. */
private fun isCloned() = StackWalker.getInstance(StackWalker.Option.RETAIN_CLASS_REFERENCE).walk { frames ->
    frames.anyMatch { it.className == LocalAgArch::class.java.name && it.descriptor == OF_CLONES && it.methodName == "createArchs" }
}

private const val OF_CLONES = "(Ljava/util/List;Ljason/asSemantics/Agent;)V"

/** Returns the reason, in words, why the agent of [ts] cannot be recorded; null if it can. */
internal fun refusal(ts: TransitionSystem): String? {
    val architectures = generateSequence(ts.agArch) { it.nextAgArch }.toList()
    val infrastructure = architectures.last()
    val strange = architectures.filter { it !is Arch && it !is Transparent && it !== infrastructure && it.javaClass != AgArch::class.java }
    return when {
        infrastructure is LocalAgArchAsynchronous ->
            "the agent has a thread each for sensing, deliberating and acting, and their simultaneous work cannot be repeated; " +
                "leave out \"asynchronous\" in the .mas2j"
        infrastructure is LocalAgArch && infrastructure.runsPartsSeveralTimes() ->
            "the agent senses, deliberates or acts several times in a cycle, which a recording cannot hold; leave that out in the .mas2j"
        strange.isNotEmpty() ->
            "besides argo.Arch the agent has the architecture ${strange.joinToString { it.javaClass.name }}, " +
                "through which more may enter it; a recording knows only argo.Arch"
        else -> null
    }
}

private fun LocalAgArch.runsPartsSeveralTimes() = cyclesSense != 1 || cyclesDeliberate != 1 || cyclesAct != 1
