package benchmarks.fleet

import argo.fleet.trial.freePorts
import benchmarks.Distribution
import benchmarks.figures
import java.util.concurrent.TimeUnit

private const val MAX_MS = 5.0
private const val PATIENCE_S = 120L
private const val START_S = 60
private val COMPUTERS = listOf("one", "two")

/** Measures the round trip of agents' messages between two processes, with the fleet and with JADE. */
internal fun pingPongs(): Boolean {
    val ports = freePorts(2)
    val fleet = pingPong("the fleet", Project.fleetOf(COMPUTERS), "") { listOf("argo.fleet.MainKt", "bench.mas2j", "--at", it) }
    val jade = pingPong("JADE", "Jade", "starting ping") { container(it, ports) }
    return fleet.ms(0.5) <= jade.ms(0.5) && fleet.ms(0.99) <= MAX_MS
}

private fun container(name: String, ports: List<Int>): List<String> {
    val own = ports[COMPUTERS.indexOf(name)]
    return listOf("jason.infra.jade.RunJadeMAS", "bench.mas2j") + (if (own == ports[0]) emptyList() else listOf("-container")) +
        "-container-name $name -host 127.0.0.1 -port ${ports[0]} -local-host 127.0.0.1 -local-port $own -nomtp".split(' ') +
        "-jade_imtp_leap_JICP_JICPServer_acceptlocalhostonly true --no-net true".split(' ')
}

/** @param ready the text that the first computer prints before the second may start */
private fun pingPong(what: String, infrastructure: String, ready: String, program: (String) -> List<String>): Distribution {
    val mas2j = "MAS bench { infrastructure: $infrastructure agents: ping at \"one\"; pong at \"two\"; }"
    return Project(mas2j, listOf("ping", "pong")).use { project ->
        val first = project.start(program(COMPUTERS[0]))
        project.await(START_S, "that $what starts") { ready in project.printed() }
        project.start(program(COMPUTERS[1]))
        check(first.waitFor(PATIENCE_S, TimeUnit.SECONDS)) { "$what does not come to an end:\n${project.printed().takeLast(2000)}" }
        val nanos = project.noted(Laps.FILE).flatten()
        check(nanos.isNotEmpty()) { "$what measured nothing:\n${project.printed().takeLast(2000)}" }
        Distribution(nanos.toLongArray()).also { times ->
            val (median, most, longest) = listOf(0.5, 0.99, 1.0).map(times::ms)
            println(figures(".send there and back over %s: median %.2f ms, p99 %.2f ms, longest %.1f ms", what, median, most, longest))
        }
    }
}
