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

/** An internal action of a project that binds its argument to [value], which is another one each time. */
abstract class SourceOfChance(private val value: () -> Any) : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        un.unifies(args[0], ASSyntax.createString("${value()}"))
}

/** Reads a clock. */
class clock : SourceOfChance(System::nanoTime)

/** Draws a number. */
class dice : SourceOfChance(Math::random)

/** Makes a name that nobody else has. */
class name : SourceOfChance(UUID::randomUUID)

/** Takes the order of a set of objects that have no hash of their own. */
class order : SourceOfChance({
    List(8) { Any() to it }.associate { it }.keys.toHashSet().joinToString { "${System.identityHashCode(it)}" }
})

/** Takes what a thread has counted. */
class counted : SourceOfChance({ AtomicLong().also { count -> thread { count.set(System.nanoTime()) }.join() } })

/** Counts its calls in the whole program. */
class calls : SourceOfChance(CALLS::incrementAndGet) {
    companion object {
        val CALLS = AtomicLong()
    }
}

/** Reads a file that changes, as another program may change it. */
class file : SourceOfChance({ FILE.readText().also { FILE.appendText("x") } }) {
    private companion object {
        val FILE = createTempFile("planted").apply { toFile().deleteOnExit() }
    }
}

/** Reads a setting of the program, which stays for each of its runs. */
class setting : SourceOfChance({ System.getProperty(PROPERTY) }) {
    companion object {
        const val PROPERTY = "planted.setting"
    }
}

/** Gives the name of a new file. */
class scratch : SourceOfChance({ createTempFile("planted").also { it.deleteExisting() } })

/** Gives the number of a new thread. */
class worker : SourceOfChance({ Thread {}.id })

/** Gives several ways, in an order of chance. */
class ways : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = List(4) { System.nanoTime() + it }.map { value ->
        un.clone().also { it.unifies(args[0], ASSyntax.createString("$value")) }
    }.iterator()
}

/** Fails by chance, with a message of chance. */
class failing : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        throw jason.JasonException("failed at ${System.nanoTime()}", ASSyntax.createAtom("chance"))
}

/** Adds a belief that is not its result. */
class believes : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any =
        ts.ag.addBel(ASSyntax.createLiteral("drawn", ASSyntax.createString("${System.nanoTime()}")))
}

/** Prints the time, as a plan prints. */
class prints : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also { ts.logger.info("${System.nanoTime()}") }
}

/** Has another thread put an event into the agent's queue, while the cycle goes on. */
class rings : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        thread { ts.c.addExternalEv(ASSyntax.parseTrigger("+ring(1)")) }.join()
    }
}

/** Has another thread add a belief. */
class tells : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        thread { ts.ag.addBel(ASSyntax.createLiteral("told")) }.join()
    }
}

/** Has a thread, which counts, resume the intention with the count. */
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

/** Leaves work for the next cycle that changes nothing of the agent; it writes, for example, the agent to a file. */
class later : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        thread { ts.runAtBeginOfNextCycle { DONE.incrementAndGet() } }.join()
        ts.runAtBeginOfNextCycle { DONE.incrementAndGet() }
    }

    companion object {
        val DONE = AtomicLong()
    }
}

/** Leaves work for the next cycle that adds a belief. */
class afterwards : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        ts.runAtBeginOfNextCycle { ts.ag.addBel(ASSyntax.createLiteral("late")) }
    }
}

/** Sends a message besides its result. */
class reports : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = true.also {
        ts.agArch.sendMsg(Message("tell", ts.agArch.agName, "boss", ASSyntax.createLiteral("done")))
    }
}

/** Gives a Java object. */
class today : DefaultInternalAction() {
    override fun execute(ts: TransitionSystem, un: Unifier, args: Array<Term>): Any = un.unifies(args[0], ObjectTermImpl(Date(0)))
}

/** A function that drifts. */
class drift : DefaultArithFunction() {
    override fun getName() = "planted.drift"

    override fun checkArity(arity: Int) = arity == 0

    override fun evaluate(ts: TransitionSystem?, args: Array<Term>) = System.nanoTime().toDouble()
}

/** An agent of a project. */
class Moody : Agent()

/** A belief base of a project. */
class Shuffled : DefaultBeliefBase()

/** A belief base whose database is not to be reached. */
class Unreachable : ChainBBAdapter() {
    override fun iterator(): MutableIterator<Literal> = error("no connection")

    override fun size(): Int = error("no connection")
}

/** An architecture of a project, that counts how often it is made. */
class Counted(platform: Platform) : Arch(platform) {
    init {
        made++
    }

    companion object {
        var made = 0
    }
}

/** A class that nobody is to make. */
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

/** Writes the agent's plans and intentions, as a project that keeps its agents does. */
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
