package argo.observing

import javino.Services
import java.util.logging.Level
import java.util.logging.Logger

/**
 * The observers that an agent's options ask for.
 *
 * @param options the options that begin with `argo_` and do not belong to `argo.Arch` itself, with their values
 */
internal class ObserverOptions(private val options: Map<String, String>, private val log: Logger) {
    private val providers: List<AgentObserverProvider> =
        if (options.isEmpty()) emptyList()
        else Services.providers(AgentObserverProvider::class.java).distinctBy { it.type() }.mapNotNull { Services.make(it) }

    val unread: Set<String> get() = options.keys - providers.map { it.option }.toSet()

    /** The options with a provider, such as `argo_view=a port number`. */
    val usages: List<String> get() = providers.map { "${it.option}=${it.usage}" }

    /** Opens the observers of [agent]. If an observer cannot be opened, logs the reason, and the agent runs without this observer. */
    fun open(agent: ObservedAgent): List<AgentObserver> = providers.mapNotNull { provider ->
        val value = options[provider.option] ?: return@mapNotNull null
        try {
            provider.open(value, agent, log)
        } catch (broken: Throwable) { // a provider is foreign code; this also catches a missing library
            log.log(Level.SEVERE, broken) { "${provider.option}=$value: ${provider.javaClass.name} failed, and the agent runs without" }
            null
        }
    }
}
