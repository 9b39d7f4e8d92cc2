package samples.collision

import argo.view.AgentView
import java.io.IOException
import java.io.InputStream
import java.io.PrintStream
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * The spectators of a run in browsers. The run waits for the first one, since opening a browser takes longer than a run.
 *
 * @property port the port of the agent's view, or 0 for any free port
 * @property waitS the longest wait for a spectator, in s
 * @property keyboard the standard input. A line from it also starts the run, and its end does not
 */
internal class Audience(val port: Int, private val waitS: Int, private val out: PrintStream, private val keyboard: InputStream) {
    private val firstBrowser = CountDownLatch(1)

    @Volatile
    private var conclusion: String? = null

    /**
     * Prints the address of [view], shows [picture] there, and waits for the first browser. If [view] is null, only prints that there is no
     * view.
     */
    fun gather(view: AgentView?, picture: () -> TrackPicture) {
        if (view == null) {
            out.println("there is no live view, since port $port is taken or not allowed; --view without a number takes one that is free")
            return
        }
        view.show {
            firstBrowser.countDown() // the view requests a picture only for a spectator
            picture().drawn(conclusion)
        }
        val waiting = if (waitS > 0) "  (the robot starts when a browser shows it, at Enter, or in $waitS s)" else ""
        out.println("live view: ${view.address}$waiting")
        awaitBrowser()
    }

    private fun awaitBrowser() {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(waitS.toLong())
        while (System.nanoTime() < deadline) if (firstBrowser.await(LOOK_MS, TimeUnit.MILLISECONDS) || isEntered()) return
    }

    /** Shows [words], the result of the run, below the picture. */
    fun conclude(words: String) {
        conclusion = words
    }

    private fun isEntered(): Boolean = try {
        keyboard.available() > 0 && keyboard.read() >= 0
    } catch (_: IOException) {
        false // there is no keyboard
    }

    private companion object {
        const val LOOK_MS = 100L
    }
}
