package argo.lsp

import argo.lsp.text.OpenTexts
import argo.lsp.text.Text
import org.eclipse.lsp4j.Diagnostic
import org.eclipse.lsp4j.PublishDiagnosticsParams
import java.util.concurrent.Future
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.TimeUnit

/**
 * Shows the findings in the editor's open texts, shortly after the last change. Findings in a replaced or closed text are dropped.
 *
 * @param worker runs [find], one call at a time
 * @param find returns the findings in a text
 * @param rehearse repeats the work that follows a change of a text, to warm up the JVM
 * @param publish sends findings to the editor
 * @param fail called with errors that [find] throws
 */
internal class Diagnostics(
    private val texts: OpenTexts,
    private val worker: ScheduledExecutorService,
    private val find: (Text) -> List<Diagnostic>,
    private val rehearse: (Text) -> Unit,
    private val publish: (PublishDiagnosticsParams) -> Unit,
    private val fail: (Throwable) -> Unit,
) {
    private var due: Future<*>? = null

    /**
     * How often [rehearse] will still be called. The calls come while nobody types. The JVM compiles code only after some runs, and the
     * compiled code is ten times as fast.
     */
    private var rounds = WARM_UP_ROUNDS

    /** The published findings and the text in which they are, by the text's URI. Only the worker uses this map. */
    private val published = HashMap<String, Pair<Text, List<Diagnostic>>>()

    /** Call this function after a text or a file on the disk was opened or changed. The search begins [PAUSE_MS] after the last call. */
    @Synchronized
    fun changed() {
        due?.cancel(false)
        due = worker.schedule(::run, PAUSE_MS, TimeUnit.MILLISECONDS)
    }

    /** Call this function after the text of [uri] was closed. The editor then removes the findings in the text. */
    fun closed(uri: String) {
        worker.execute { if (texts[uri] == null && published.remove(uri) != null) publish(PublishDiagnosticsParams(uri, emptyList())) }
        changed()
    }

    private fun run() {
        texts.all().forEach { reporting { diagnose(it) } } // a text that cannot be checked costs the others nothing
        reporting { worker.execute(::warmUp) }
    }

    private fun reporting(work: () -> Unit) {
        try {
            work()
        } catch (failure: Throwable) { // an executor would hide the failure
            if (!worker.isShutdown) fail(failure)
        }
    }

    /** Calls [rehearse] once and queues the next call. So a key or a request waits for at most one call. */
    private fun warmUp() {
        if (rounds == 0 || !isIdle()) return
        rounds--
        texts.all().lastOrNull()?.let(rehearse)
        worker.execute(::warmUp)
    }

    @Synchronized
    private fun isIdle() = due?.isDone != false

    private fun diagnose(text: Text) {
        if (texts[text.uri] !== text) return // another run handles the newer text
        val found = find(text)
        if (published[text.uri]?.let { (last, its) -> last === text && its == found } == true) return
        texts.ifCurrent(text) {
            publish(PublishDiagnosticsParams(text.uri, found, text.version))
            published[text.uri] = text to found
        }
    }

    private companion object {
        /** After a longer pause, the user has probably ended a word. After a shorter pause, the next key makes results useless. */
        const val PAUSE_MS = 20L
        const val WARM_UP_ROUNDS = 60
    }
}
