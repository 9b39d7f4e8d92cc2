package argo.lsp

import argo.lsp.text.OpenTexts
import argo.lsp.text.Text
import org.eclipse.lsp4j.Diagnostic
import org.eclipse.lsp4j.PublishDiagnosticsParams
import java.util.concurrent.Future
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.TimeUnit

/**
 * Shows findings in the editor's open texts, shortly after the last change. A replaced or closed text gets no findings.
 *
 * @param worker runs [find], one call at a time
 * @param find returns the findings in a text
 * @param rehearse does the work of a change of the text
 * @param publish sends findings to the editor
 * @param fail takes the errors that [find] throws
 */
internal class Diagnosis(
    private val texts: OpenTexts,
    private val worker: ScheduledExecutorService,
    private val find: (Text) -> List<Diagnostic>,
    private val rehearse: (Text) -> Unit,
    private val publish: (PublishDiagnosticsParams) -> Unit,
    private val fail: (Throwable) -> Unit,
) {
    private var due: Future<*>? = null

    /**
     * The remaining warm-up rounds. Warm-up rounds run while nobody types, since the JVM compiles code after a few runs and makes it ten
     * times as fast.
     */
    private var rounds = WARM_UP_ROUNDS

    /** The published findings with their text, by its URI. Only the worker uses this map. */
    private val published = HashMap<String, Pair<Text, List<Diagnostic>>>()

    /** Call this after a text or a file on the disk was opened or changed. The search begins when no more changes come. */
    @Synchronized
    fun changed() {
        due?.cancel(false)
        due = worker.schedule(::run, PAUSE_MS, TimeUnit.MILLISECONDS)
    }

    /** Call this after the text of [uri] was closed. The editor then stops showing the findings in that text. */
    fun closed(uri: String) {
        worker.execute { if (texts[uri] == null && published.remove(uri) != null) publish(PublishDiagnosticsParams(uri, emptyList())) }
        changed()
    }

    private fun run() = try {
        texts.all().forEach(::diagnose)
        worker.execute(::warmUp)
    } catch (failure: Throwable) { // an executor would hide the failure
        fail(failure)
    }

    /** Makes one warm-up round and queues the next. So a key or a request waits for one round at most. */
    private fun warmUp() {
        if (rounds == 0 || !isIdle()) return
        rounds--
        texts.all().lastOrNull()?.let(rehearse)
        worker.execute(::warmUp)
    }

    @Synchronized
    private fun isIdle() = due?.isDone != false

    private fun diagnose(text: Text) {
        if (texts[text.uri] !== text) return // a newer text has a run of its own
        val found = find(text)
        if (published[text.uri]?.let { (last, its) -> last === text && its == found } == true) return
        texts.ifCurrent(text) {
            publish(PublishDiagnosticsParams(text.uri, found, text.version))
            published[text.uri] = text to found
        }
    }

    private companion object {
        /** A longer pause between two keys ends a word. After a shorter pause the next key would make the result useless. */
        const val PAUSE_MS = 20L
        const val WARM_UP_ROUNDS = 60
    }
}
