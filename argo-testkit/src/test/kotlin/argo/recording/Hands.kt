package argo.recording

import argo.Arch
import argo.observing.ObservedAgent
import argo.observing.Order
import argo.observing.Outcome
import argo.platform.Plans
import argo.testkit.TestAgent
import io.kotest.matchers.nulls.shouldNotBeNull
import jason.asSyntax.Plan
import kotlin.time.Duration.Companion.milliseconds

internal val TestAgent.observed: ObservedAgent
    get() = generateSequence(ts.agArch) { it.nextAgArch }.filterIsInstance<Arch>().first().observed

internal fun TestAgent.ordered(order: Order): Outcome {
    var outcome: Outcome? = null
    mas.open {
        observed.order(order) { outcome = it }
        mas.time.settle()
    }
    after(20.milliseconds)
    return outcome.shouldNotBeNull()
}

internal object Programs {
    fun plansOf(agent: TestAgent): List<Plan> = Plans.of(agent.ts.ag).all.filter { it.sourceFile != "kqmlPlans.asl" }
}
