package argo.fleet.trial

import argo.fleet.cluster.TestCertificates
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import kotlin.random.Random

/** Kills processes of a fleet and unplugs computers at random. */
@Tags("Thorough")
class TrialSpec : FunSpec({
    blockingTest = true
    val names = listOf("base", "scout1", "scout2", "scout3")

    /** Disturbs one of them about every two seconds. The first two stay, so that each message has a chance. */
    fun Trial.disturb(network: Namespaces?, random: Random) = repeat(8) {
        val name = names.random(random)
        Thread.sleep(500L + random.nextLong(1500))
        when {
            name !in running -> start(name)
            network == null || random.nextBoolean() -> kill(name)
            else -> {
                network.unplug(name)
                Thread.sleep(random.nextLong(6000))
                network.plug(name)
            }
        }
    }

    fun Trial.run(network: Namespaces?, seed: Int) {
        names.forEach(::start)
        awaitAll()
        send()
        disturb(network, Random(seed))
        names.filter { it !in running }.forEach(::start)
        awaitAll()
        finish()
        history().faults().take(20).shouldBeEmpty()
        history().count(Kind.TAKEN) shouldBeGreaterThan 1000
    }

    test("processes that are killed and started again lose, double and disorder nothing, and encrypt it") {
        val made = TestCertificates(tempdir().toPath(), *names.toTypedArray())
        val folders = names.associateWith { made.of(it, *names.toTypedArray()) }
        Trial(names, null, folders::getValue).use { it.run(null, 1) }
    }

    test("computers that are unplugged too lose, double and disorder nothing").config(
        enabledOrReasonIf = { Namespaces.missing?.let(Enabled::disabled) ?: Enabled.enabled },
    ) {
        Namespaces(names).use { network -> Trial(names, network).use { it.run(network, 2) } }
    }
})
