package argo.ports

import argo.acting.Commands
import argo.platform.Platform
import argo.sensing.Sensing
import argo.sensing.SensingListener
import jason.asSyntax.Term
import javino.Link
import java.util.concurrent.ConcurrentHashMap

/**
 * A port that an agent holds open: its link, the commands that wait for it and its sensing.
 *
 * @param names what the agent calls it, and the names that it opens it by
 * @property openedNanos when it was opened, by the platform's clock
 * @property losses how often in a row it had been lost before, each time soon after it was opened
 * @param platform what its threads run on
 */
internal class OpenPort(
    names: Map<Term, String>,
    val link: Link,
    val options: PortOptions,
    val openedNanos: Long,
    val losses: Int,
    owner: String,
    listener: SensingListener,
    platform: Platform,
) {
    private val namesByTerm = ConcurrentHashMap(names)

    /** All that the agent calls it, and the names that it opens it by: a device may be asked for by several. */
    val names: Map<Term, String> get() = namesByTerm

    /** All that the agent calls it. */
    val terms: Set<Term> get() = namesByTerm.keys

    /** Whether a message has come from the board. */
    @Volatile
    var hasSpoken = false

    /** What the agent wants done. */
    val commands = Commands(link, owner, platform) { listener.lost(this, it) }

    /** What the board says. */
    val sensing = Sensing(this, owner, listener, platform)

    /** The agent calls it [term], too, and opens it by [name]. */
    fun isCalled(term: Term, name: String) {
        namesByTerm[term] = name
    }

    /** Gives the port up: waiting commands fail, both threads end. Never waits. May be called twice and by any thread. */
    fun close() {
        link.close()
        sensing.close()
        commands.close()
    }
}
