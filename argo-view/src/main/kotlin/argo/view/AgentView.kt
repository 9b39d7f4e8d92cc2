package argo.view

import argo.observing.AgentObserver
import argo.observing.Farewell
import argo.observing.ObservedAgent
import kotlinx.serialization.json.Json
import java.net.URI
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.logging.Level
import java.util.logging.Logger

/**
 * The live view of one agent: a page that browsers on this computer can open while the agent runs. The option `argo_view=8080` of an agent
 * opens the view. `argo_view=0` takes any free port. The view is one of [argo.Arch.observers]. If agents of one program have equal numbers,
 * they share the port, and their pages have links to each other.
 *
 * Neither the agent nor its sensing ever waits for the view. Safe for use by several threads.
 */
class AgentView private constructor(
    private val agent: ObservedAgent,
    private val port: Int,
    private val log: Logger,
    private val record: AgentRecord,
) : AgentObserver by record {
    private val page = AgentPage(agent)
    private val pages = page.states
    private val server = ViewServers.join(port, page)
    private val composer = StateComposer(agent, record, page.breakpoints, server.site::tabs, log)
    private val closing = CountDownLatch(1)
    private var publishedNanos: Long? = null
    private var hasFailed = false
    private val publisher = Thread(::publish, "argo-${agent.name}-view").apply { isDaemon = true }

    /** Shows the agent's end on the pages when the whole program ends. */
    private val farewell = Farewell(MAX_FAREWELL_MS, "the program has ended before the pages of agent ${agent.name} showed the end") {
        close()
        publisher.join()
    }

    /** @throws java.io.IOException if the port cannot be opened */
    internal constructor(agent: ObservedAgent, port: Int, log: Logger) : this(agent, port, log, AgentRecord(agent, log))

    init {
        record.begin()
        publisher.start()
    }

    /** The view's address, such as `http://127.0.0.1:8080/bob/`. */
    val address: URI get() = server.address.resolve(page.path)

    /**
     * Shows a picture at the top of the page. The view's thread calls [picture] at most ten times a second while a page is open. It also
     * calls [picture] once when the agent has ended. [picture] must return soon. If [picture] returns null, nothing is shown. If [picture]
     * throws, the exception is logged, and there is no further call.
     */
    fun show(picture: () -> Picture?) {
        composer.picture = picture
    }

    /** Shows the agent's end on the pages, frees the port and ends all threads. Returns at once. Further calls have no effect. */
    override fun close() {
        record.close()
        closing.countDown()
    }

    private fun publish() {
        try {
            server.start()
            while (!closing.await(INTERVAL_MS, TimeUnit.MILLISECONDS)) guarded(::publishIfNew)
            guarded { publish(isLast = true) }
            pages.awaitNoPage(MAX_FAREWELL_MS) // does not wait for a page that does not read
        } finally {
            ViewServers.leave(port, server, page)
            farewell.close()
        }
    }

    /** Does [work]. If it throws, the pages miss a state, and the view goes on. Only the first exception is logged. */
    private fun guarded(work: () -> Unit) {
        try {
            work()
        } catch (broken: Throwable) { // a state has texts of the project's own terms and pictures
            if (!hasFailed) log.log(Level.WARNING, "the live view misses a state, and further ones without a report", broken)
            hasFailed = true
        }
    }

    private fun publishIfNew() {
        server.closeStalled()
        val mind = record.mind
        mind.isWatched = pages.isWatched
        if (!mind.isWatched) return composer.takeIn()
        if (!agent.pausing.look(mind::look) && mind.isBehind()) agent.wake()
        val isNewPage = pages.takeNewPage()
        val isDue = publishedNanos.let { it == null || System.nanoTime() - it >= REPEAT_NANOS }
        if (isNewPage || isDue || composer.hasNews()) publish(isLast = false, isFull = isNewPage)
    }

    private fun publish(isLast: Boolean, isFull: Boolean = true) {
        pages.publish(Json.encodeToString(ViewState.serializer(), composer.state(isLast, isFull)), isLast)
        publishedNanos = System.nanoTime()
    }

    private companion object {
        const val INTERVAL_MS = 100L
        val REPEAT_NANOS = TimeUnit.SECONDS.toNanos(1)
        const val MAX_FAREWELL_MS = 1000L
    }
}
