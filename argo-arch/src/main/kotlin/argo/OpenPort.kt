package argo

import jason.asSyntax.Term
import javino.Link
import java.util.concurrent.CopyOnWriteArraySet

/**
 * A port that an agent holds open: its link, the commands that wait for it and its sensing.
 *
 * @param term the port as the agent calls it
 * @param platform what its threads run on
 */
internal class OpenPort(
    term: Term,
    val link: Link,
    val options: PortOptions,
    owner: String,
    listener: SensingListener,
    platform: Platform,
) {
    private val names = CopyOnWriteArraySet(listOf(term))

    /** All that the agent calls it: a device may be asked for by several names. */
    val terms: Set<Term> get() = names

    /** What the agent wants done. */
    val commands = Commands(link, owner, platform) { listener.lost(this, it) }

    /** What the board says. */
    val sensing = Sensing(this, owner, listener, platform)

    /** The agent calls it [term] too. */
    fun isCalled(term: Term) {
        names += term
    }

    /** Gives the port up: waiting commands fail, both threads end. Never waits. May be called twice and by any thread. */
    fun close() {
        link.close()
        sensing.close()
        commands.close()
    }
}
