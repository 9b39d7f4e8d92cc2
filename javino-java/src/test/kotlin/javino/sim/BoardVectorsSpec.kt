package javino.sim

import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import javino.BoardReceiver
import javino.PerceptKind
import javino.PerceptTerm
import javino.PerceptsRequest
import javino.Protocol
import javino.sim.BoardProgram.Outcome
import javino.wire.BoardAction
import javino.wire.BoardRule
import javino.wire.CommandItem
import javino.wire.FrameKind
import javino.wire.Vectors2
import javino.wire.Welcome
import javino.wire.WireDecoder
import javino.wire.WireFrame
import javino.wire.bytesOf
import javino.wire.frameOf
import javino.wire.isNull
import javino.wire.isTrue
import javino.wire.items
import javino.wire.number
import javino.wire.octets
import javino.wire.text
import javino.wire.texts
import javino.wire.vectorOf
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive

private class VectorProgram(
    private val actions: List<BoardAction>,
    private val refused: List<String>,
    private val later: List<String>,
    private val kinds: List<PerceptKind>,
) : BoardProgram {
    val carried = mutableListOf<String>()
    var percepts = emptyList<String>()

    override fun vocabulary() = actions

    override fun perceptKinds() = kinds

    override fun carryOut(command: String): Outcome {
        val term = PerceptTerm.of(command)
        val action = actions.lastOrNull { it.name() == term.functor() }
        val takes = action != null && action.arguments() in listOf(term.arguments().size, BoardAction.ANY)
        if (command in refused || !takes) return Outcome.REFUSED
        carried += command
        return if (command in later) Outcome.LATER else Outcome.DONE
    }

    override fun percepts(request: String): String {
        val wanted = PerceptsRequest.functorsIn(request)
        return percepts.filter { wanted.isEmpty() || PerceptTerm.of(it).functor() in wanted }.joinToString("")
    }
}

private class VectorBoard(board: JsonObject) {
    val sent = mutableListOf<WireFrame>()
    val program = VectorProgram(
        board["actions"].items().map { BoardAction(it.jsonArray[0].text(), it.jsonArray[1].number()) },
        board["refuses"].texts(),
        board["later"].texts(),
        board["kinds"]?.texts().orEmpty().map(PerceptKind::parse),
    )
    var answers = emptyList<String>()
    private var session = newSession()
    private var begun = 0

    private fun newSession() = BoardSession(program, BoardSession.Capacity(60, 255, 4, 126)) { frame, _ -> sent += frame }

    private fun handle(message: String): String? {
        session.end()
        if (PerceptsRequest.isIn(message)) return program.percepts(message)
        program.carryOut(message)
        return null
    }

    private fun receive(frame: WireFrame, nonce: Int?) {
        if (frame.kind() == FrameKind.HELLO) begun = frame.number()
        val bytes = frame.toBytes(nonce ?: begun)
        WireDecoder(false, 100 * MS, session::nonce, session::receive).accept(bytes, 0, bytes.size, 0)
    }

    fun step(step: JsonObject) {
        sent.clear()
        program.carried.clear()
        step["percepts"]?.let { program.percepts = it.texts() }
        if (step["restart"].isTrue()) session = newSession()
        if (step["restart"].isTrue() || "messages" in step) begun = 0
        answers = step["messages"]?.texts()?.mapNotNull(::handle) ?: emptyList()
        step["to"]?.texts()?.forEach { receive(frameOf(it), step["nonce"]?.number()) }
        step["report"]?.let { session.report(session.openAction(), it.text() == "done") }
        if (step["look"].isTrue()) session.look(program.percepts(PerceptsRequest.ALL))
        if (step["unasked"].isTrue()) session.sendPercepts(program.percepts(PerceptsRequest.ALL))
    }
}

/** A frame for comparison. WELCOME keeps only the nonce, because boards differ in capacity. */
private fun comparable(frame: WireFrame) =
    if (frame.kind() != FrameKind.WELCOME) vectorOf(frame)
    else "WELCOME ${frame.number()} ${frame.isRefused} ${frame.isBusy} ${Welcome.read(frame.payload()).nonce()}"

class BoardVectorsSpec : FunSpec({
    test("there are vectors of all groups") {
        for (group in listOf("board", "rules")) Vectors2.cases(group).size shouldBeGreaterThan 5
    }

    for ((name, case) in Vectors2.cases("board")) test("board: $name") {
        val board = VectorBoard(case.getValue("board").jsonObject)
        case["steps"].items().map { it.jsonObject }.forEachIndexed { i, step ->
            withClue("step ${i + 1}: $step") {
                board.step(step)
                board.sent.map(::comparable) shouldBe step["from"].texts().map { comparable(frameOf(it)) }
                board.program.carried shouldBe (step["carried"]?.texts() ?: emptyList())
                board.answers shouldBe (step["answers"]?.texts() ?: emptyList())
            }
        }
    }

    for ((name, case) in Vectors2.cases("rules")) test("rule: $name") {
        val rule = BoardRule.read(CommandItem.Rule(case["command"].text()))
        if (case["met"].isNull()) {
            rule shouldBe null
        } else {
            case["percepts"].texts().map { HeldRules.isMet(rule, PerceptTerm.of(it), false) } shouldBe
                case["met"].items().map { it.jsonPrimitive.boolean }
        }
    }

    for ((name, case) in Vectors2.cases("receive").filter { (_, case) -> case["direction"].text() == "to-board" }) test("receive: $name") {
        val found = mutableListOf<BoardReceiver.Found>()
        val receiver = BoardReceiver(Protocol.AUTO, 100 * MS, 255, { case["session"].number() }, found::add)
        var now = 0L
        for (chunk in case["chunks"].items().map { it.jsonObject }) {
            val gap = chunk["gapMs"].number() * MS
            now += gap
            receiver.idle(now)
            bytesOf(chunk["hex"].octets()).forEachIndexed { i, octet -> receiver.accept(octet, now, if (i == 0) gap else 0) }
        }
        receiver.idle(now + 200 * MS)
        found.mapNotNull { it.version2() }.map(::vectorOf) shouldBe case["frames"].texts()
        found.mapNotNull { it.version1()?.text() } shouldBe case["version1"].texts()
        receiver.nanosUntilIdle(now + 200 * MS) shouldBe Long.MAX_VALUE
    }
})

private const val MS = 1_000_000L
