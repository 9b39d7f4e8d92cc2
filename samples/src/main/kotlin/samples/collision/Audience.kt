package samples.collision

import argo.view.AgentView
import argo.view.DistancePicture
import java.io.IOException
import java.io.InputStream
import java.io.PrintStream
import java.util.concurrent.TimeUnit

/**
 * Those who watch a run in a browser. The run waits for the first of them, since it is over before a browser could be opened.
 *
 * @property port where the agent's view is to be, 0 being any port that is free
 * @param waitS for how long the run waits, in s
 * @param out where is said where the view is
 * @param keyboard where Enter ends the waiting; one that says nothing, or has ended, does not
 */
internal class Audience(val port: Int, private val waitS: Int, private val out: PrintStream, private val keyboard: InputStream) {
    private var view: AgentView? = null

    /** Says where [view] is and waits for the first browser; null: the view could not be had, which is said. */
    fun gather(view: AgentView?, picture: () -> DistancePicture) {
        this.view = view
        if (view == null) return out.println("there is no live view, since port $port is taken or not allowed; --view without a number takes one that is free")
        view.show(picture)
        out.println("live view: ${view.address}" + if (waitS > 0) "  (the robot starts when a browser shows it, at Enter, or in $waitS s)" else "")
        awaitBrowser(view)
    }

    private fun awaitBrowser(view: AgentView) {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(waitS.toLong())
        while (System.nanoTime() < deadline) if (view.awaitBrowser(LOOK_MS) || isEntered()) return
    }

    /** Tells them how the run ended. */
    fun conclude(words: String) {
        view?.conclude(words)
    }

    /** Waits until they have been told; the agent must have been stopped. */
    fun dismiss() {
        view?.awaitEnd(FAREWELL_MS)
    }

    private fun isEntered(): Boolean = try {
        keyboard.available() > 0 && keyboard.read() >= 0
    } catch (_: IOException) {
        false // there is no keyboard
    }

    private companion object {
        const val LOOK_MS = 100L
        const val FAREWELL_MS = 3000L
    }
}
