package argo

import argo.calls.ArgumentException
import argo.filters.FilterException
import argo.filters.FilterNotFoundException
import argo.filters.PerceptionFilter
import argo.filters.matching.warnings
import argo.perception.EnvironmentFilter
import argo.perception.filterOf
import jason.asSyntax.Literal
import jason.asSyntax.StringTerm
import jason.asSyntax.Term
import java.io.IOException
import java.util.ServiceConfigurationError
import java.util.logging.Logger

/**
 * The internal action `argo.change_filter(F)`: activates filter F from the next perception on. F is an atom or a string, the name of a
 * filter or of its file; `none` lets everything through. `argo.change_filter(F)` changes the filter of all boards. `argo.change_filter(F,
 * [port(P)])` changes only the filter of the board on P. The action also works for agents without [Arch]. Their percepts come from a Jason
 * environment.
 *
 * The log names the parts of the filter that have no effect.
 *
 * Fails the plan, and keeps the filter unchanged, with `error(wrong_arguments)`, `error(unknown_board)`, `error(no_such_filter)` or
 * `error(bad_filter)`. If a file is refused, the message lists all its problems.
 */
@Suppress("ClassName")
open class change_filter : BoardInternalAction("argo.change_filter", 1..2) {
    @Transient
    private val reported = HashSet<Pair<String, PerceptionFilter>>() // Jason makes one instance for each agent

    override fun run(call: Call) {
        val filter = find(call, filterName(call.args[0]))
        val board = boardIn(call)
        if (board != null) return call.arch.boards.perceiveThrough(filter, board)
        val archs = architectures(call.ts)
        archOf(call.ts)?.let { return it.perceiveThrough(filter) }
        val environmentFilter = archs.filterIsInstance<EnvironmentFilter>().firstOrNull() ?: EnvironmentFilter.insertInto(call.ts)
        environmentFilter.perceiveThrough(filter)
    }

    private fun find(call: Call, name: String): PerceptionFilter? = try {
        filterOf(call.ts.ag, name)?.also { warn(call, it) }
    } catch (missing: FilterNotFoundException) {
        throw call.failure("no_such_filter", missing.message.orEmpty())
    } catch (refused: FilterException) {
        throw call.failure("bad_filter", refused.message.orEmpty())
    } catch (broken: ServiceConfigurationError) {
        throw call.failure("bad_filter", "a filter provider on the class path cannot be used: ${broken.message}")
    } catch (broken: RuntimeException) {
        throw call.failure("bad_filter", "looking for the filter $name ended in $broken")
    } catch (unreadable: IOException) {
        throw call.failure("bad_filter", "the filter $name cannot be read: $unreadable")
    }

    /** Logs the parts of [filter] that have no effect, once for each content of a filter. */
    private fun warn(call: Call, filter: PerceptionFilter) {
        if (!reported.add(filter.name to filter)) return
        val log = Logger.getLogger("${Arch::class.java.name}.${call.ts.agArch.agName}")
        filter.warnings().forEach { log.warning("filter ${filter.name}: $it") }
    }
}

private fun filterName(term: Term): String = when {
    term is StringTerm -> term.string
    term is Literal && term.isAtom -> term.functor
    else -> throw ArgumentException("a filter is named by an atom or a string, not by $term")
}
