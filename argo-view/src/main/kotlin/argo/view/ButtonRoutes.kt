package argo.view

import argo.observing.ObservedAgent
import argo.observing.Order
import argo.observing.Outcome
import argo.observing.Pausing
import argo.observing.StopAt
import kotlinx.serialization.Serializable

/** Responds to the buttons that change [agent] or pause it. Safe for use by several threads. */
internal class ButtonRoutes(private val agent: ObservedAgent, private val breakpoints: PageBreakpoints) {
    val routes: Map<String, Route> = mapOf(
        "/believe" to ordering("believed", Order::Believe),
        "/forget" to ordering("forgotten", Order::Forget),
        "/begin" to ordering("begun", Order::Begin),
        "/drop" to ordering("dropped", Order::Drop),
        "/reload" to Route.post<NoRequest> { reload() },
        "/pause" to Route.post<NoRequest> { told("the agent is asked to pause") { pause() } },
        "/go" to Route.post<NoRequest> { told("the agent goes on") { goOn() } },
        "/step" to Route.post<NoRequest> { told("the agent goes on for a cycle") { goOnUntil(StopAt.NextCycle) } },
        "/until" to Route.post<TextRequest> { told("the agent goes on until ${it.text}") { goOnUntil(stopAt(it.text.trim())) } },
        "/breakpoint" to Route.post<BreakpointRequest> { breakpoint(it.place.trim(), it.isSet) },
    )

    private fun ordering(done: String, order: (String) -> Order) = Route.post<TextRequest> { request ->
        Route.awaited { answer -> agent.order(order(request.text)) { answer(response(it, "${request.text}: $done")) } }
    }

    private fun reload() = Route.awaited { answer -> agent.reload { answer(response(it, "nothing has changed")) } }

    /** Returns a response with the text of [outcome], or with [done] if [outcome] has no text. */
    private fun response(outcome: Outcome, done: String): HttpResponse = outcome.refusal?.let { HttpResponse.message(422, it) }
        ?: HttpResponse.message(200, outcome.told.joinToString("\n").ifEmpty { done })

    private fun told(message: String, ask: Pausing.() -> Unit): HttpResponse {
        agent.pausing.refusal?.let { return HttpResponse.message(422, it) }
        return try {
            agent.pausing.ask()
            HttpResponse.message(200, message)
        } catch (wrong: IllegalArgumentException) {
            HttpResponse.message(422, wrong.message.orEmpty())
        }
    }

    private fun stopAt(text: String): StopAt = when (text.firstOrNull()) {
        '+', '-' -> StopAt.ChosenPlan(text)
        '@' -> StopAt.ChosenPlan(text.drop(1))
        else -> StopAt.Belief(text)
    }

    private fun breakpoint(place: String, isSet: Boolean): HttpResponse {
        val (file, line) = LINE.matchEntire(place)?.destructured
            ?: return HttpResponse.message(422, "$place is no line of a program: write robot.asl:12")
        return if (isSet) breakpoints.set(file, line.toInt()) else breakpoints.remove(file, line.toInt())
    }

    @Serializable
    private class NoRequest

    @Serializable
    private class TextRequest(val text: String)

    @Serializable
    private class BreakpointRequest(val place: String, val isSet: Boolean = true)

    private companion object {
        val LINE = Regex("""(.+):(\d{1,6})""")
    }
}
