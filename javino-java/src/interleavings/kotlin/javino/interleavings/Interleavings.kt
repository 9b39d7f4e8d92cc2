package javino.interleavings

import org.jetbrains.lincheck.datastructures.ModelCheckingOptions
import org.jetbrains.lincheck.datastructures.Operation
import org.jetbrains.lincheck.datastructures.Validate
import org.jetbrains.lincheck.datastructures.forClasses
import org.jetbrains.lincheck.datastructures.verifier.EpsilonVerifier
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread

/**
 * Runs [block], which calls [concurrently], in many interleavings of its threads. The system property `argo.interleavings` is the number
 * of interleavings. Fails at the first interleaving in which [block] throws or its threads deadlock, and shows that interleaving.
 *
 * Runs the block once before the check, so the check does not include class loading.
 *
 * @param divisor divides the number of interleavings, for a long block
 */
internal fun inEachInterleaving(divisor: Int = 1, block: () -> Unit) {
    block()
    checked = block
    val options = ModelCheckingOptions()
        .iterations(0) // no random scenarios
        .invocationsPerIteration(maxOf(1, Integer.getInteger("argo.interleavings", 20) / divisor))
        .loopIterationsBeforeThreadSwitch(LONGEST_LOOP).loopBound(100 * LONGEST_LOOP)
        .addGuarantee(forClasses { name -> ATOMIC.any(name::startsWith) }.allMethods().treatAsAtomic())
        .verifier(EpsilonVerifier::class.java).minimizeFailedScenario(false) // [CheckedBlock.holds] verifies the result
        .addCustomScenario { parallel { thread { actor(CheckedBlock::run) } } }
    // With the default timeout of 30 s, a busy machine fails to instrument the classes of the first invocation.
    options.javaClass.getMethod("invocationTimeout\$lincheck", Long::class.java).invoke(options, 600_000L)
    options.check(CheckedBlock::class.java)
}

/** Runs each function of [work] on its own thread. Returns when all have ended. Throws the exception of a function that failed. */
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
 * The number of loop iterations after which Lincheck lets another thread run. With the default of ten, Lincheck takes a loop over a
 * frame's bytes for a waiting loop and stops exploring. A higher number makes each wait slower.
 */
private const val LONGEST_LOOP = 40

/** Packages in which Lincheck switches no threads: only one thread at a time uses their classes. */
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
