package argo.recording.agent

import argo.hand.Order
import argo.recording.GivenOrder

private const val BELIEVE = "believe"
private const val FORGET = "forget"
private const val BEGIN = "begin"
private const val DROP = "drop"

/** Returns [order] as a recording contains it. */
internal fun given(order: Order): GivenOrder = when (order) {
    is Order.Believe -> GivenOrder(BELIEVE, order.literal)
    is Order.Forget -> GivenOrder(FORGET, order.literal)
    is Order.Begin -> GivenOrder(BEGIN, order.goal)
    is Order.Drop -> GivenOrder(DROP, order.goal)
}

/**
 * Returns the order that was [given].
 * @throws IllegalArgumentException if this version of ARGO has no such order
 */
internal fun orderOf(given: GivenOrder): Order = when (given.kind) {
    BELIEVE -> Order.Believe(given.text)
    FORGET -> Order.Forget(given.text)
    BEGIN -> Order.Begin(given.text)
    DROP -> Order.Drop(given.text)
    else -> throw IllegalArgumentException("a recording holds the order ${given.kind}, which this version of ARGO does not know")
}
