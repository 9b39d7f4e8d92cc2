package javino.interleavings

import org.jetbrains.lincheck.datastructures.ModelCheckingOptions
import org.jetbrains.lincheck.datastructures.Operation
import org.jetbrains.lincheck.datastructures.Validate
import org.jetbrains.lincheck.datastructures.forClasses
import org.jetbrains.lincheck.datastructures.verifier.EpsilonVerifier
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread

/**
 * Runs [block], which calls [concurrently], in many interleavings of its threads. The system property `argo.interleavings` is the number of
 * interleavings. Fails at the first interleaving in which [block] throws or its threads deadlock, and shows that interleaving.
 *
 * The block first runs once unchecked, so that the loading of classes is not part of the check.
 *
 * @param divisor the number by which the number of interleavings is divided, for a long block
 */
internal fun inEachInterleaving(divisor: Int = 1, block: () -> Unit) {
    block()
    checked = block
    val options = ModelCheckingOptions()
        .iterations(0) // no random scenarios, only the one below
        .invocationsPerIteration(maxOf(1, Integer.getInteger("argo.interleavings", 20) / divisor))
        .loopIterationsBeforeThreadSwitch(LONGEST_LOOP).loopBound(100 * LONGEST_LOOP)
        .addGuarantee(forClasses { name -> ATOMIC.any(name::startsWith) }.allMethods().treatAsAtomic())
        .verifier(EpsilonVerifier::class.java).minimizeFailedScenario(false) // the block checks itself
        .addCustomScenario { parallel { thread { actor(CheckedBlock::run) } } }
    // A busy machine needs more than the default of 30 s to instrument the classes of the first invocation.
    options.javaClass.getMethod("invocationTimeout\$lincheck", Long::class.java).invoke(options, 600_000L)
    options.check(CheckedBlock::class.java)
}

/** Runs all of [work] at once, each function on a thread of its own. Returns when all have ended; throws the exception of a failed one. */
internal fun concurrently(vararg work: () -> Unit) {
    val failure = AtomicReference<Throwable?>()
    val threads = ArrayList<Thread>()
    for (each in work) {
        threads += thread {
            try {
                each()
            } catch (thrown: Throwable) {
                failure.set(thrown)
            }
        }
    }
    for (thread in threads) thread.join()
    failure.get()?.let { throw it }
}

/**
 * The most rounds of a loop that waits for no other thread. After this number of rounds Lincheck lets another thread run. With the default
 * of ten, Lincheck would take a loop over a frame's bytes for a waiting loop, and stop exploring. A thread that really waits makes this
 * number of rounds before another runs, so a higher number costs time.
 */
private const val LONGEST_LOOP = 40

/** Packages whose classes only one thread at a time uses: Lincheck switches no threads in them. */
private val ATOMIC = listOf(
    "jason.", "argo.filters.", "javino.session.", "javino.sim.", "javino.wire.", "kotlin.collections.", "kotlin.text.",
)

private lateinit var checked: () -> Unit

internal class CheckedBlock {
    private var failure: Throwable? = null

    @Operation
    fun run() {
        try {
            checked()
        } catch (thrown: Throwable) {
            failure = thrown
        }
    }

    @Validate
    fun holds() {
        failure?.let { throw it }
    }
}
