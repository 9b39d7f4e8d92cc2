package argo.view

import argo.observing.ObservedAgent
import argo.observing.Order
import argo.observing.Outcome
import kotlinx.serialization.Serializable

/** Responds to the buttons that order [agent] to believe or intend something. Safe for use by several threads. */
internal class HandRoutes(private val agent: ObservedAgent) {
    val routes: Map<String, Route> = mapOf(
        "/believe" to ordering("believed", Order::Believe),
        "/forget" to ordering("forgotten", Order::Forget),
        "/begin" to ordering("begun", Order::Begin),
        "/drop" to ordering("dropped", Order::Drop),
    )

    private fun ordering(done: String, order: (String) -> Order) = Route.post<TextRequest> { request ->
        Route.awaited { answer -> agent.order(order(request.text)) { answer(response(it, "${request.text}: $done")) } }
    }

    /** Responds with what [outcome] tells; with [done] if it tells nothing. */
    private fun response(outcome: Outcome, done: String): HttpResponse = outcome.refusal?.let { HttpResponse.message(422, it) }
        ?: HttpResponse.message(200, outcome.told.joinToString("\n").ifEmpty { done })

    @Serializable
    private class TextRequest(val text: String)
}
