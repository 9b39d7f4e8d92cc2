package argo.jason

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.comparables.shouldBeLessThanOrEqualTo

private val COUNT = Regex("""b(\d+)::count\((\d+)\)""")

@Tags("Thorough")
class RealBoardsSpec : FunSpec({
    fun counts(beliefs: Set<String>) = beliefs.mapNotNull { COUNT.matchEntire(it)?.destructured }
        .associate { (board, count) -> board.toInt() to count.toInt() }

    /** Tells for each board which of its answers was perceived last, and how many it has sent. */
    fun described(boards: List<NetworkBoard>, perceived: Map<Int, Int>) = "${perceived.size} of ${boards.size} boards perceived: " +
        boards.withIndex().joinToString { (i, board) -> "b$i ${perceived[i] ?: "no answer"} of ${board.answers}" }

    fun threads(prefix: String) = Thread.getAllStackTraces().keys.map { it.name }.filter { it.startsWith(prefix) }

    test("127 boards on the network are perceived by one agent, each in its namespace, and closed with it") {
        val boards = (1..127).map { NetworkBoard() }
        try {
            LocalMas().use { mas ->
                val ports = boards.mapIndexed { i, board -> "port(\"${board.port}\",[as(b$i)])" }
                mas.agent("bob", """
                    !start.
                    +!start <- argo.limit(200); argo.percepts(open); argo.ports(${ports.joinToString(",", "[", "]")}); +all.
                    +b126::count(X) : X > 5 <- argo.act(b0::last(X)).
                """)
                mas.awaitBelief("bob", "all")
                val perceived = HashMap<Int, Int>() // by board, its last answer that was seen among the beliefs
                awaitGrowth(boards.size, { "${described(boards, perceived)}\n${mas.log}" }) {
                    perceived += counts(mas.beliefs("bob"))
                    perceived.size
                }
                eventually(LIMIT) {
                    withClue({ described(boards, perceived + counts(mas.beliefs("bob"))) }) {
                        boards.first().received.map { it.substringBefore('(') } shouldContain "last"
                    }
                }
                threads("argo-bob-").size shouldBeLessThanOrEqualTo 2 * boards.size
                mas.kill("bob")
                eventually(LIMIT) { (threads("argo-bob-") + threads("write ")).shouldBeEmpty() }
            }
        } finally {
            boards.forEach(NetworkBoard::close)
        }
    }

    test("a module for a board is included once for each") {
        val boards = List(2) { NetworkBoard() }
        try {
            LocalMas().use { mas ->
                val module = mas.file("counter.asl", "+count(X) : X > 3 <- argo.act(enough(X)); +told.\n-count(X) <- +gone.")
                val ports = boards.zip(listOf("left", "right")) { board, name -> "port(\"${board.port}\",[as($name)])" }
                mas.agent("bob", """
                    { include("$module", left) }
                    { include("$module", right) }
                    !start.
                    +!start <- argo.percepts(open); argo.ports(${ports.joinToString(",", "[", "]")}).
                """)
                for (belief in listOf("left::told", "right::told", "left::gone", "right::gone")) mas.awaitBelief("bob", belief)
                eventually(LIMIT) { for (board in boards) board.received.map { it.substringBefore('(') } shouldContain "enough" }
                mas.kill("bob")
            }
        } finally {
            boards.forEach(NetworkBoard::close)
        }
    }
})
