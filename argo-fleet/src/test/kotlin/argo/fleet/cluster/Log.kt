package argo.fleet.cluster

import java.util.concurrent.CopyOnWriteArrayList

/** Stores what a cluster reports. Refuses a message `no`. */
internal class Log : ClusterListener {
    val messages = CopyOnWriteArrayList<Pair<String, String>>()
    val views = CopyOnWriteArrayList<ClusterView>()
    val refusals = CopyOnWriteArrayList<String>()
    val computers: Set<String> get() = views.lastOrNull()?.computers?.keys.orEmpty()

    fun from(name: String): List<String> = messages.filter { it.first == name }.map { it.second }

    override fun message(from: String, message: ByteArray) {
        if (String(message) == "no") throw Refused("unwanted", "I do not want it")
        messages += from to String(message)
    }

    override fun changed(view: ClusterView) {
        views += view
    }

    override fun refused(reason: String) {
        refusals += reason
    }
}
