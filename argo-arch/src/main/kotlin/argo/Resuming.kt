package argo

import argo.filters.jason.PerceptReader
import argo.filters.jason.PerceptSyntaxException
import argo.filters.jason.perceptText
import argo.mind.Mind
import argo.observing.AgentObserver
import argo.observing.Order
import argo.observing.Outcome
import argo.observing.PausePhase
import argo.observing.PauseState
import argo.platform.Platform
import argo.resuming.MergedState
import argo.resuming.State
import argo.resuming.StateFile
import argo.resuming.StateWriter
import argo.resuming.UnreadableStateException
import jason.asSemantics.Unifier
import jason.asSyntax.Literal
import jason.infra.local.LocalAgArchAsynchronous
import java.io.IOException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import java.util.logging.Logger
import kotlin.concurrent.withLock

/**
 * Implements the option `argo_resume`: keeps the state of the agent of [arch] in [file]. When the agent starts again, it continues from
 * this state. The agent's thread composes the state between two cycles.
 *
 * @param wallMs ms since 1970
 */
internal class Resuming(
    private val arch: Arch,
    private val file: StateFile,
    private val platform: Platform,
    private val log: Logger,
    private val wallMs: () -> Long = System::currentTimeMillis,
) : AgentObserver {
    private val name = arch.agName
    private val setUp = BoardSetUp(arch, platform, ::warn)
    private var awaited: List<String> = emptyList() // events that begin when all ports are open
    private var readable: Set<String> = emptySet() // literals with a text that was read back and compared
    private val program = beginning()
    private val leftOut = HashSet<String>()
    private val writer = StateWriter(file, name, platform, log, ::close)
    private var madeNanos = platform.clock.nanos() - PERIOD_NANOS // so the first state is kept at once

    @Volatile
    private var isResumed = false // false while the file holds the state of the last run

    private val ending = ReentrantLock() // held while a thread other than the agent's composes the last state

    @Volatile
    private var isInCycle = false

    @Volatile
    private var isStopped = false
    private var isLastMade = false
    private var isDue = false // only the agent's thread uses it

    init {
        arch.pausing.follow { if (it.phase == PausePhase.PAUSED) keepWhile(it) }
    }

    /** Returns the initial beliefs and goals of the program. Events of beliefs are left out. */
    private fun beginning(): Mind = Mind.of(arch.ts, ::write) {}.run { copy(events = events.filter { it.startsWith("!") }) }

    /** If the file holds a state, lets the agent continue from it. Called before the agent's first cycle. */
    fun begin(order: (Order, (Outcome) -> Unit) -> Unit) {
        val state = read()
        isResumed = state == null
        if (state == null) return
        val awayMs = (wallMs() - state.writtenMs).coerceAtLeast(0)
        val merged = MergedState(state, program)
        log.info("$name goes on from $file, which was written $awayMs ms ago${merged.told}")
        order(Order.Resume(merged.beliefs + (listOf("$RESUMED$awayMs)") + merged.newBeliefs).map { "+$it" })) { outcome ->
            tell(outcome)
            awaited = merged.events
            isResumed = true
        }
        setUp.restore(state.setUp) {
            order(Order.BeginAnew(merged.events)) { outcome ->
                tell(outcome)
                awaited = emptyList()
            }
        }
    }

    private fun tell(outcome: Outcome) = (listOfNotNull(outcome.refusal) + outcome.told).forEach(::warn)

    private fun warn(what: String) = log.warning("$OPTION: $what")

    private fun read(): State? {
        val why = try {
            return file.read()?.let { State.of(name, it) }
        } catch (broken: UnreadableStateException) {
            broken.message
        } catch (_: CharacterCodingException) {
            "it is no text in UTF-8"
        } catch (unreadable: IOException) {
            "$unreadable"
        }
        val fate = try {
            "is kept as ${file.setAside()}"
        } catch (trouble: IOException) {
            "cannot be renamed either ($trouble)"
        }
        log.severe("$OPTION: $file cannot be read: $why. It $fate, and $name begins as its program says")
        return null
    }

    /** Returns the text of [literal]. Throws [IllegalArgumentException] if the text cannot be read back as an equal literal. */
    private fun write(literal: Literal): String {
        val text = perceptText(literal)
        if (text in readable) return text
        val again = try {
            PerceptReader.read(text).capply(Unifier())
        } catch (wrong: PerceptSyntaxException) {
            throw IllegalArgumentException(wrong.message)
        }
        require(!literal.isGround || again == literal) { "Jason's notation has no text for it" }
        return text
    }

    fun cycleStarting() {
        isInCycle = true
        if (isStopped) ending.withLock { } // another thread may be composing the last state
    }

    override fun cycleFinished() {
        if (isResumed && (isDue || platform.clock.nanos() - madeNanos >= PERIOD_NANOS)) keep()
        isInCycle = false
        if (isStopped) ending.withLock { keep() }
    }

    /** Keeps the state soon after a person's order. Called by the agent's thread. */
    fun ordered() {
        isDue = !keepStanding()
    }

    /** Keeps the state periodically during the pause [standing], since the state contains times. */
    private fun keepWhile(standing: PauseState) {
        if (arch.pausing.state === standing && keepStanding()) platform.later(PERIOD_MS) { keepWhile(standing) }
    }

    /** If the agent is paused between two cycles, makes its thread keep the state and returns true. Else returns false. */
    private fun keepStanding(): Boolean = !platform.standsStill && arch.pausing.look(::keep)

    /** Composes the agent's state and gives it to the writer. The agent must not change during this call. */
    private fun keep() {
        if (isLastMade) return
        madeNanos = platform.clock.nanos()
        isLastMade = isStopped
        isDue = false
        if (isResumed) writer.write(state())
        if (isLastMade) writer.end()
    }

    private fun state(): State {
        val mind = Mind.of(arch.ts, ::write) { left -> if (leftOut.add(left)) warn("$file does not keep $left") }
        readable = (mind.beliefs + mind.events.map { it.drop(1) }).toSet()
        val (beliefs, events) = mind
        return State(
            name, wallMs(), setUp.calls(), program,
            Mind(beliefs.filterNot { it.startsWith(RESUMED) }, awaited + events.filterNot { it.startsWith("+$RESUMED") }),
        )
    }

    /**
     * Keeps the last state at once or, during a cycle, after the cycle. If the agent is paused within a cycle, its own thread keeps the
     * state.
     */
    override fun close() {
        ending.withLock {
            if (isStopped) return
            isStopped = true
            if (isInCycle) keepStanding() else keep()
        }
    }

    companion object {
        const val OPTION = "argo_resume"

        /** A sleeping agent has a cycle each second, so beliefs in the file are at most five seconds old. */
        private const val PERIOD_MS = 4000L
        private val PERIOD_NANOS = TimeUnit.MILLISECONDS.toNanos(PERIOD_MS)
        private const val RESUMED = "resumed("

        /**
         * Reserves the file [value] for the agent of [arch]. If the agent cannot have the file, tells [log] the reason and returns null.
         */
        fun open(arch: Arch, value: String, platform: Platform, log: Logger): Resuming? {
            fun refuse(why: String) =
                null.also { log.severe("$OPTION=$value: $why; ${arch.agName} begins as its program says, and keeps nothing") }

            val infrastructure = architectures(arch.ts).last()
            if (infrastructure is LocalAgArchAsynchronous) return refuse("an agent with three threads has no moment between two cycles")
            val path = try {
                Path.of(value.trim().removeSurrounding("\"")).toAbsolutePath().normalize()
            } catch (wrong: InvalidPathException) {
                return refuse("that is no name of a file (${wrong.message})")
            }
            if (Files.isDirectory(path)) return refuse("that is a folder; it takes the name of a file, such as \"robot.state\"")
            if (!Files.isDirectory(path.parent)) return refuse("there is no folder ${path.parent}; make it")
            val file = StateFile.take(path)
                ?: return refuse("another agent has this file, in this program or in another one; each agent needs its own")
            return Resuming(arch, file, platform, log)
        }
    }
}
