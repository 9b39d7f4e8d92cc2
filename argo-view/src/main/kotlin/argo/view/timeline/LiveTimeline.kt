package argo.view.timeline

import argo.recording.RunningRecordings
import argo.recording.replay.Recording
import argo.view.AgentLanes
import argo.view.AgentLanesProvider
import argo.view.HttpResponse
import argo.view.parametersOf
import java.io.IOException
import java.time.Duration

/**
 * The timeline of the last minutes of the running [agent]. The timeline is read from the agent's recording when a page is opened or asks
 * again. Only the newest timeline is kept. Without requests, the timeline takes no time of the computer.
 */
internal class LiveTimeline(private val agent: String) : AgentLanes {
    private var number = 0
    private val why = ToldWhy { ask -> RunningRecordings.of(agent)?.read { ask(listOf(it)) } }

    @Volatile
    private var newest: TimelineRoutes? = null

    override fun respond(path: String, query: String?): HttpResponse? = when (path) {
        "/timeline" -> TimelineRoutes.page()
        "/recording" -> taken()
        "/why" -> why.respond(parametersOf(query))
        "/items", "/item" -> part(path, parametersOf(query))
        else -> TimelineRoutes.file(path)
    }

    private fun part(path: String, parameters: Map<String, String>): HttpResponse {
        val routes = newest?.takeIf { "${it.number}" == parameters["of"] }
        return routes?.respond(path, parameters) ?: HttpResponse.message(409, "the lanes are older than those of another page; press Now")
    }

    /** Reads the current recording, for one page at a time. Many pages then take no more memory than one page. */
    @Synchronized
    private fun taken(): HttpResponse {
        val recording = try {
            RunningRecordings.of(agent) ?: return HttpResponse.message(404, "agent $agent is not recorded; $REMEDY")
        } catch (_: NoClassDefFoundError) {
            return HttpResponse.message(404, "the library argo-recording is not on the class path; argo.jar has it")
        }
        return try {
            val timeline = recording.read { file -> Recording(file).use { Timeline.of(it, LAST) } }
            val routes = TimelineRoutes(timeline, agent, listOfNotNull(recording.trouble), why, ++number)
            routes.also { newest = it }.respond("/recording", emptyMap())
        } catch (unreadable: IOException) {
            unreadable(unreadable)
        } catch (unreadable: IllegalArgumentException) { // thrown by an unreadable message
            unreadable(unreadable)
        }
    }

    private fun unreadable(trouble: Exception) =
        HttpResponse.message(500, "the recording of agent $agent cannot be read: ${trouble.message ?: trouble}")

    private companion object {
        /** How much of the recording the timeline covers. More would take too much time and memory. */
        val LAST: Duration = Duration.ofMinutes(2)
        const val REMEDY = "write argo_record=\"last(5)\" beside argo_view in the .mas2j, which keeps the last five minutes in memory"
    }
}

/** Adds the timeline to the live view. */
internal class LiveTimelineProvider : AgentLanesProvider {
    override fun open(agent: String): AgentLanes = LiveTimeline(agent)
}
