package argo.lsp

import argo.lsp.text.OpenTexts
import argo.lsp.text.Text
import org.eclipse.lsp4j.Diagnostic
import org.eclipse.lsp4j.PublishDiagnosticsParams
import java.util.concurrent.Future
import java.util.concurrent.ScheduledExecutorService
import java.util.concurrent.TimeUnit

/**
 * Tells the editor what is wrong with its open texts, shortly after the last change, and never about a text that is gone.
 *
 * @param worker runs [find], one call at a time
 * @param find returns what is wrong with a text
 * @param rehearse does the work of a change of the text
 * @param publish sends it to the editor
 * @param fail takes what [find] throws
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

    /** The rounds that are left to make while nobody types: code that has run a few times is compiled, and ten times as fast. */
    private var rounds = WARM_UP_ROUNDS

    /** Published diagnostics with their text, by its URI. Only the worker uses it. */
    private val published = HashMap<String, Pair<Text, List<Diagnostic>>>()

    /** A text was opened or changed, or a file on the disk: what is wrong is looked for once no more changes come. */
    @Synchronized
    fun changed() {
        due?.cancel(false)
        due = worker.schedule(::run, PAUSE_MS, TimeUnit.MILLISECONDS)
    }

    /** The text of [uri] was closed, so that the editor shows nothing of it any more. */
    fun closed(uri: String) {
        worker.execute { if (texts[uri] == null && published.remove(uri) != null) publish(PublishDiagnosticsParams(uri, emptyList())) }
        changed()
    }

    private fun run() = try {
        texts.all().forEach(::diagnose)
        worker.execute(::warmUp)
    } catch (failure: Throwable) { // an executor would keep it to itself
        fail(failure)
    }

    /** Makes one round, and leaves the next ones to later, so that no key and no request waits longer than for one. */
    private fun warmUp() {
        if (rounds == 0 || !isIdle()) return
        rounds--
        texts.all().lastOrNull()?.let(rehearse)
        worker.execute(::warmUp)
    }

    @Synchronized
    private fun isIdle() = due?.isDone != false

    private fun diagnose(text: Text) {
        if (texts[text.uri] !== text) return // a newer one is there, and with it another run
        val found = find(text)
        if (published[text.uri]?.let { (last, its) -> last === text && its == found } == true) return
        texts.ifCurrent(text) {
            publish(PublishDiagnosticsParams(text.uri, found, text.version))
            published[text.uri] = text to found
        }
    }

    private companion object {
        /** A pause between two keys that is longer ends a word; a shorter one would compute what the next key makes useless. */
        const val PAUSE_MS = 20L
        const val WARM_UP_ROUNDS = 60
    }
}
