package argo.recording.agent

import argo.observing.Order
import argo.observing.ProgramFile
import argo.recording.GivenFile
import argo.recording.GivenOrder

private const val BELIEVE = "believe"
private const val FORGET = "forget"
private const val BEGIN = "begin"
private const val DROP = "drop"
private const val RELOAD = "reload"
private const val RESUME = "resume"
private const val BEGIN_ANEW = "begin_anew"

/** Returns [order] in the form of a recording. */
internal fun given(order: Order): GivenOrder = when (order) {
    is Order.Believe -> GivenOrder(BELIEVE, order.literal)
    is Order.Forget -> GivenOrder(FORGET, order.literal)
    is Order.Begin -> GivenOrder(BEGIN, order.goal)
    is Order.Drop -> GivenOrder(DROP, order.goal)
    is Order.Reload -> GivenOrder(
        RELOAD, files = order.files.map { GivenFile(it.within, it.name, it.address, it.text) }, gone = order.gone,
    )
    is Order.Resume -> GivenOrder(RESUME, order.beliefs.joinToString("\n"))
    is Order.BeginAnew -> GivenOrder(BEGIN_ANEW, order.events.joinToString("\n"))
}

/**
 * Returns the order that the recorded order [given] describes.
 *
 * @throws IllegalArgumentException if this version of ARGO does not know the order
 */
internal fun orderOf(given: GivenOrder): Order = when (given.kind) {
    BELIEVE -> Order.Believe(given.text)
    FORGET -> Order.Forget(given.text)
    BEGIN -> Order.Begin(given.text)
    DROP -> Order.Drop(given.text)
    RELOAD -> Order.Reload(given.files.map { ProgramFile(it.within, it.name, it.address, it.text) }, given.gone)
    RESUME -> Order.Resume(given.text.lines())
    BEGIN_ANEW -> Order.BeginAnew(given.text.lines().filter { it.isNotEmpty() })
    else -> throw IllegalArgumentException("a recording holds the order ${given.kind}, which this version of ARGO does not know")
}
