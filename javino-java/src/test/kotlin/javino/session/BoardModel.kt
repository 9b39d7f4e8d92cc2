package javino.session

import javino.wire.BoardAction
import javino.wire.CommandItem
import javino.wire.FrameKind
import javino.wire.PerceptWriter
import javino.wire.VocabularyPage
import javino.wire.Welcome
import javino.wire.WireFrame

/**
 * A minimal model of the board's end of version 2, after docs/protocol.md. The model answers each frame at once.
 *
 * @param percepts returns the answer to a request with these functors
 * @param actions the vocabulary
 * @param act carries a command out; false: refuses it; null: it continues until [finish]
 */
internal class BoardModel(
    private val actions: List<BoardAction> = emptyList(),
    private val credit: Int = 60,
    private val percepts: (String) -> String = { "" },
    private val act: (String) -> Boolean?,
) {
    var nonce = 0
        private set
    private var due = 0
    private var isRefused = false
    private var isBusy = false
    private val writer = PerceptWriter(16)
    private var known = 0

    /** Length of a part of an answer in bytes. */
    var partSize = 253

    fun restart() {
        nonce = 0
        due = 0
        isRefused = false
        isBusy = false
    }

    private fun begin(session: Int) {
        restart()
        nonce = session
        writer.forget()
        known = 0
    }

    fun received(frame: WireFrame): List<WireFrame> {
        if (frame.kind() == FrameKind.HELLO) {
            if (frame.number() != nonce) begin(frame.number())
            return listOf(frame(FrameKind.WELCOME, Welcome(nonce, credit, 255, 4).payload()))
        }
        if (nonce == 0) return listOf(frame(FrameKind.WELCOME, Welcome.NO_SESSION.payload()))
        return when (frame.kind()) {
            FrameKind.ASK -> {
                known = frame.payload()[0].code
                answer(frame.number(), percepts(frame.payload().drop(1)))
            }
            FrameKind.DESCRIBE ->
                listOf(frame(FrameKind.VOCABULARY, VocabularyPage.of(frame.number(), frame.payload()[0].code, actions, 40).payload()))
            else -> listOf(commands(frame))
        }
    }

    fun say(text: String): List<WireFrame> = answer(0, text)

    fun finish(isDone: Boolean = true): WireFrame {
        isBusy = false
        due = due + 1 and 0xFF
        isRefused = !isDone
        return frame(FrameKind.ACK, "")
    }

    private fun answer(request: Int, text: String): List<WireFrame> {
        val items = writer.items(text.split(AFTER_PERCEPT).filter(String::isNotEmpty), known)
        val number = request.toChar()
        if (items.length <= partSize) return listOf(frame(FrameKind.PERCEPTS, number + items))
        val parts = items.chunked(partSize)
        return parts.mapIndexed { i, part ->
            frame(if (i == parts.lastIndex) FrameKind.PERCEPTS_LAST else FrameKind.PERCEPTS_PART, "$number${i.toChar()}$part")
        }
    }

    private fun commands(frame: WireFrame): WireFrame {
        if (frame.kind() == FrameKind.COMMANDS_WITH_RESUME && frame.number() == due) isRefused = false
        CommandItem.read(frame.payload()).forEachIndexed { i, item ->
            if ((frame.number() + i and 0xFF) == due && !isRefused && !isBusy) carryOut(item)
        }
        return frame(FrameKind.ACK, "")
    }

    private fun carryOut(item: CommandItem) {
        val done = when (item) {
            is CommandItem.Nothing -> true
            is CommandItem.Action -> act(actions[item.number()].name())
            is CommandItem.Text -> act(item.text())
            is CommandItem.Rule -> true
        }
        isBusy = done == null
        if (done == null) return
        due = due + 1 and 0xFF
        isRefused = !done
    }

    private companion object {
        val AFTER_PERCEPT = Regex("(?<=;)")
    }

    private fun frame(kind: FrameKind, payload: String) = WireFrame(kind, isRefused, isBusy, due, payload)
}
