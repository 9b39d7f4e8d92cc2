@file:Suppress("ClassName")

package planted

import argo.Arch
import argo.platform.Plans
import argo.platform.Platform
import jason.asSemantics.Agent
import jason.asSemantics.ConcurrentInternalAction
import jason.asSemantics.DefaultArithFunction
import jason.asSemantics.DefaultInternalAction
import jason.asSemantics.Message
import jason.asSemantics.TransitionSystem
import jason.asSemantics.Unifier
import jason.asSyntax.ASSyntax
import jason.asSyntax.Literal
import jason.asSyntax.ObjectTermImpl
import jason.asSyntax.Term
import jason.bb.ChainBBAdapter
import jason.bb.DefaultBeliefBase
import java.io.ByteArrayOutputStream
import java.io.ObjectOutputStream
import java.util.Date
import java.util.UUID
import java.util.concurrent.atomic.AtomicLong
import kotlin.concurrent.thread
import kotlin.io.path.appendText
import kotlin.io.path.createTempFile
import kotlin.io.path.deleteExisting
import kotlin.io.path.readText

/** An internal action that binds its argument to [value], which differs at each call. */
abstract class SourceOfChance(private val value: () -> Any) : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        un.unifies(args[0], ASSyntax.createString("${value()}"))
}

class clock : SourceOfChance(System::nanoTime)

class dice : SourceOfChance(Math::random)

class name : SourceOfChance(UUID::randomUUID)

/** Takes the order of a set of objects without a hash code of their own. */
class order : SourceOfChance({
    List(8) { Any() to it }.associate { it }.keys.toHashSet().joinToString { "${System.identityHashCode(it)}" }
})

/** Takes a number that a thread has set. */
class counted : SourceOfChance({ AtomicLong().also { count -> thread { count.set(System.nanoTime()) }.join() } })

/** Has a mistake, as a program in Java may have. */
class mistaken : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = error("the mistake")
}

/** Counts its calls in the whole program. */
class calls : SourceOfChance(CALLS::incrementAndGet) {
    companion object {
        val CALLS = AtomicLong()
    }
}

class file : SourceOfChance({ FILE.readText().also { FILE.appendText("x") } }) {
    private companion object {
        val FILE = createTempFile("planted").apply { toFile().deleteOnExit() }
    }
}

/** Reads a property, which is constant in each run of the program. */
class setting : SourceOfChance({ System.getProperty(PROPERTY) }) {
    companion object {
        const val PROPERTY = "planted.setting"
    }
}

class scratch : SourceOfChance({ createTempFile("planted").also { it.deleteExisting() } })

class worker : SourceOfChance({ Thread {}.id })

/** Gives several solutions in random order. */
class ways : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = List(4) { System.nanoTime() + it }.map { value ->
        un.clone().also { it.unifies(args[0], ASSyntax.createString("$value")) }
    }.iterator()
}

/** Fails at random, with a random message. */
class failing : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        throw jason.JasonException("failed at ${System.nanoTime()}", ASSyntax.createAtom("chance"))
}

/** Adds a belief beside its result. */
class believes : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        ts.ag.addBel(ASSyntax.createLiteral("drawn", ASSyntax.createString("${System.nanoTime()}")))
}

class prints : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also { ts.logger.info("${System.nanoTime()}") }
}

/** Makes another thread add an event to the agent's queue during the cycle. */
class rings : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        thread { ts.c.addExternalEv(ASSyntax.parseTrigger("+ring(1)")) }.join()
    }
}

class tells : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        thread { ts.ag.addBel(ASSyntax.createLiteral("told")) }.join()
    }
}

/** Makes a counting thread resume the intention with the count. */
class counts : ConcurrentInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        val key = suspendInt(ts, "counting", 0)
        thread {
            un.unifies(args[0], ASSyntax.createNumber(3.0))
            resumeInt(ts, key)
        }
        return true
    }

    override fun timeout(ts: TransitionSystem, key: String) = failInt(ts, key)
}

/** Schedules work for the next cycle. The work does not change the agent. */
class later : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        thread { ts.runAtBeginOfNextCycle { DONE.incrementAndGet() } }.join()
        ts.runAtBeginOfNextCycle { DONE.incrementAndGet() }
    }

    companion object {
        val DONE = AtomicLong()
    }
}

/** Schedules work for the next cycle. The work adds a belief. */
class afterwards : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        ts.runAtBeginOfNextCycle { ts.ag.addBel(ASSyntax.createLiteral("late")) }
    }
}

class reports : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        ts.agArch.sendMsg(Message("tell", ts.agArch.agName, "boss", ASSyntax.createLiteral("done")))
    }
}

class today : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = un.unifies(args[0], ObjectTermImpl(Date(0)))
}

/** A function whose value changes. */
class drift : DefaultArithFunction() {
    override fun getName() = "planted.drift"

    override fun checkArity(arity: Int) = arity == 0

    override fun evaluate(ts: TransitionSystem?, args: Array<Term>) = System.nanoTime().toDouble()
}

class Moody : Agent()

class Shuffled : DefaultBeliefBase()

/** A belief base with an unreachable database. */
class Unreachable : ChainBBAdapter() {
    override fun iterator(): MutableIterator<Literal> = error("no connection")

    override fun size(): Int = error("no connection")
}

class Counted(platform: Platform) : Arch(platform) {
    init {
        made++
    }

    companion object {
        var made = 0
    }
}

/** An architecture of a project, as most are, that takes no platform. */
class Plain : Arch()

/** A class that a replay must never instantiate. */
class Bomb : java.io.Serializable {
    init {
        explosions++
    }

    private fun readObject(stream: java.io.ObjectInputStream) {
        stream.defaultReadObject()
        explosions++
    }

    companion object {
        var explosions = 0
    }
}

/** Serializes the agent's plans and its work for the next cycle. */
class writes : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any {
        val bytes = ByteArrayOutputStream()
        ObjectOutputStream(bytes).use { stream ->
            stream.writeObject(ArrayList(Plans.of(ts.ag).all))
            stream.writeObject(TransitionSystem::class.java.getDeclaredField("taskForBeginOfCycle").apply { isAccessible = true }.get(ts))
        }
        val classes = bytes.toByteArray().decodeToString()
        return un.unifies(args[0], ASSyntax.createString(if ("argo.recording" in classes) "the recorder, too" else "written"))
    }
}
