package argo.view

import argo.observing.AgentObserver
import argo.observing.AgentObserverProvider
import argo.observing.ObservedAgent
import kotlinx.serialization.json.Json
import java.io.IOException
import java.net.BindException
import java.net.URI
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.logging.Logger

/**
 * The live view of one agent: a page that browsers on this computer can open while the agent runs. An agent has one whose options
 * say `argo_view=8080`, or `argo_view=0` for any port that is free; it is among [argo.Arch.observers].
 *
 * Neither the agent nor its sensing ever waits for it. Safe for use by several threads.
 */
class AgentView private constructor(
    private val agent: ObservedAgent,
    port: Int,
    log: Logger,
    private val beliefs: BeliefWatch,
    private val record: AgentRecord,
) : AgentObserver by record {
    private val nanos: () -> Long = agent::nanos
    private val browsers = Browsers(MOST_BROWSERS, nanos)
    private val states = Newest<ViewServer.Sent>()
    private val server = ViewServer(agent.name, port, ViewCommands(agent), browsers, states, nanos)
    private val composer = StateComposer(agent, record, beliefs, log, nanos)
    private val closing = CountDownLatch(1)
    private val publisher = Thread(::publish, "argo-${agent.name}-view").apply {
        isDaemon = true
        start()
    }

    /** Where it is, such as `http://127.0.0.1:8080/`. */
    val address: URI get() = server.address

    /**
     * Shows a picture above all else: [picture] is asked for it by the view's thread, ten times a second at most and only while a browser
     * watches. It must return soon, with null when there is nothing to show; if it throws, that is logged and it is not asked again.
     */
    fun show(picture: () -> DistancePicture?) {
        composer.picture = picture
    }

    /** Says in [words] how it ended, for the page to show when the agent has ended. */
    fun conclude(words: String) {
        composer.conclusion = words
    }

    /** Waits until a browser shows the page, at most [limitMs] ms, and returns whether one does or has done. */
    fun awaitBrowser(limitMs: Long): Boolean = browsers.awaitFirst(limitMs)

    /** Waits until the view has gone, at most [limitMs] ms: after the agent's end, until the browsers have been told and the port is free. */
    fun awaitEnd(limitMs: Long) = publisher.join(limitMs)

    /** Shows the browsers the agent's end and gives the port and all threads back. Returns at once; may be called twice. */
    override fun close() = closing.countDown()

    private fun publish() {
        try {
            server.start()
            var shown: Long? = null
            while (!closing.await(INTERVAL_MS, TimeUnit.MILLISECONDS)) shown = publishIfNew(shown)
            states.say(sent(isLast = true))
            awaitBrowsers()
        } finally {
            server.stop()
        }
    }

    /** Returns when something was [shown] last to those who watch; null: nobody does. */
    private fun publishIfNew(shown: Long?): Long? {
        server.giveUpUnfinished(UNFINISHED_NANOS)
        beliefs.isWatched = browsers.areWatching()
        if (!beliefs.isWatched) return null
        browsers.giveUpStalled(STALLED_NANOS)
        if (beliefs.isBehind()) agent.wake()
        val isDue = shown == null || nanos() - shown >= REPEAT_NANOS
        if (!browsers.hasNewcomer() && !isDue && !composer.hasNews()) return shown
        states.say(sent(isLast = false))
        return nanos()
    }

    private fun sent(isLast: Boolean) = ViewServer.Sent(Json.encodeToString(ViewState.serializer(), composer.state(isLast)), isLast)

    /** Until they know the end; one that does not read is not waited for. */
    private fun awaitBrowsers() {
        val deadline = nanos() + FAREWELL_NANOS
        while (browsers.areWatching() && nanos() < deadline) TimeUnit.MILLISECONDS.sleep(FAREWELL_STEP_MS)
    }

    internal companion object {
        private const val INTERVAL_MS = 100L
        private const val REPEAT_NANOS = 1_000_000_000L
        private const val STALLED_NANOS = 15_000_000_000L

        /** How long a request may take to come whole, over a slow tunnel too. */
        private const val UNFINISHED_NANOS = 10_000_000_000L
        private const val FAREWELL_NANOS = 1_000_000_000L
        private const val FAREWELL_STEP_MS = 10L
        private const val MOST_BROWSERS = 12

        /**
         * Opens the view that the option [text] asks for, and logs where it is; null if it cannot be had, which is logged as well.
         */
        fun open(text: String, agent: ObservedAgent, log: Logger): AgentView? {
            val port = text.trim().toIntOrNull()?.takeIf { it in 0..MOST_PORT }
            if (port == null) {
                log.severe("argo_view=$text: a view has the number of a port from 0 to $MOST_PORT, 0 being any that is free, as in argo_view=8080; the agent runs without a view")
                return null
            }
            return try {
                opened(agent, port, log).also { log.info("the live view of ${agent.name} is at ${it.address}") }
            } catch (taken: BindException) {
                log.severe("argo_view=$port: port $port cannot be had, it is in use or not allowed (${taken.message}); choose another, or 0 for any that is free. The agent runs without a view")
                null
            } catch (trouble: IOException) {
                log.severe("argo_view=$port: the view cannot be opened ($trouble); the agent runs without one")
                null
            } catch (missing: LinkageError) { // a Java that was put together without it
                log.severe("argo_view=$port: this Java has no HTTP server, which is in its module jdk.httpserver ($missing); the agent runs without a view")
                null
            }
        }

        private fun opened(agent: ObservedAgent, port: Int, log: Logger): AgentView {
            val beliefs = BeliefWatch(agent::beliefs, log, agent::nanos)
            return AgentView(agent, port, log, beliefs, AgentRecord(beliefs, agent::nanos))
        }

        private const val MOST_PORT = 65535
    }
}

/** Opens the live views of agents whose options have `argo_view`. */
class AgentViewProvider : AgentObserverProvider {
    override val option = "argo_view"
    override val usage = "a port number"

    override fun open(value: String, agent: ObservedAgent, log: Logger): AgentObserver? = AgentView.open(value, agent, log)
}
