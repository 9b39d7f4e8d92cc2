package argo.view

import argo.observing.ObservedAgent
import argo.observing.Order
import argo.observing.Outcome
import kotlinx.serialization.Serializable

/** Responds to the buttons that change the mind and the program of [agent]. Safe for use by several threads. */
internal class HandRoutes(private val agent: ObservedAgent) {
    val routes: Map<String, Route> = mapOf(
        "/believe" to ordering("believed", Order::Believe),
        "/forget" to ordering("forgotten", Order::Forget),
        "/begin" to ordering("begun", Order::Begin),
        "/drop" to ordering("dropped", Order::Drop),
        "/reload" to Route.post<NoRequest> { reload() },
    )

    private fun ordering(done: String, order: (String) -> Order) = Route.post<TextRequest> { request ->
        Route.awaited { answer -> agent.order(order(request.text)) { answer(response(it, "${request.text}: $done")) } }
    }

    private fun reload() = Route.awaited { answer -> agent.reload { answer(response(it, "nothing has changed")) } }

    /** Responds with what [outcome] tells; with [done] if it tells nothing. */
    private fun response(outcome: Outcome, done: String): HttpResponse = outcome.refusal?.let { HttpResponse.message(422, it) }
        ?: HttpResponse.message(200, outcome.told.joinToString("\n").ifEmpty { done })

    @Serializable
    private class NoRequest

    @Serializable
    private class TextRequest(val text: String)
}
