package argo.view.timeline

import argo.tools.why.Told
import argo.tools.why.WhyProgram
import argo.view.HttpResponse
import kotlinx.serialization.Serializable
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.atomic.AtomicBoolean

/**
 * Explains why a command was sent, in the sentences of the tool `why`. Answers one question at a time and refuses others, since they would
 * block threads that respond to pages. Any thread may ask.
 *
 * @param reading calls its argument with the files of the agents' recordings; returns null if there is none
 */
internal class ToldWhy(private val reading: ((List<Path>) -> Told) -> Told?) {
    private val program = WhyProgram(PATIENCE_S)
    private val isBusy = AtomicBoolean()

    /** Answers a request for `why` with the [parameters] `agent` and `command`, the command's number. Waits for the answer. */
    fun respond(parameters: Map<String, String>): HttpResponse {
        val agent = parameters["agent"]
        val number = parameters["command"]?.toLongOrNull()
        if (agent == null || number == null || number < 1) return HttpResponse.message(400, "ask for why?agent=robot&command=17")
        if (isBusy.getAndSet(true)) return HttpResponse.message(409, "another question is being answered; ask again in some seconds")
        return try {
            answer(agent, number)
        } finally {
            isBusy.set(false)
        }
    }

    private fun answer(agent: String, number: Long): HttpResponse {
        val told = try {
            reading { files -> program.ask(files, agent, number) }
                ?: return HttpResponse.message(404, "agent $agent is not recorded any more")
        } catch (trouble: IOException) {
            return HttpResponse.message(500, "the tool why cannot be run: ${trouble.message}")
        }
        if (told.lines.isEmpty()) return HttpResponse.message(404, told.trouble.ifEmpty { "the tool why has ended without an answer" })
        return HttpResponse.json(Sentences(told.lines))
    }

    @Serializable
    private class Sentences(val lines: List<String>)

    private companion object {
        const val PATIENCE_S = 60L
    }
}
