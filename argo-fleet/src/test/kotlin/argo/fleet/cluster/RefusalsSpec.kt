package argo.fleet.cluster

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import java.util.concurrent.TimeUnit

class RefusalsSpec : FunSpec({
    var minutes = 0L
    val told = ArrayList<String>()
    val refusals = Refusals(now = { TimeUnit.MINUTES.toNanos(minutes) }, log = told::add)

    beforeTest { told.clear() }

    test("a reason is told once in ten minutes, whatever the stranger sends") {
        repeat(1000) { refusals.tell("a stranger at 10.0.0.9 speaks no language of a fleet: it sent \"$it\"") }
        told shouldBe listOf("a stranger at 10.0.0.9 speaks no language of a fleet: it sent \"0\" (told once in 10 minutes)")
        minutes += 10
        refusals.tell("a stranger at 10.0.0.9 speaks no language of a fleet: it sent \"x\"")
        told.size shouldBe 2
    }

    test("of ever new reasons some are told, and that there are more") {
        minutes += 10
        repeat(1000) { refusals.tell("x$it belongs to the fleet y") }
        told.size shouldBe 65
        told.last() shouldBe "for 10 minutes no further reason is told"
        minutes += 10
        refusals.tell("x1 belongs to the fleet y")
        told.last() shouldBe "x1 belongs to the fleet y (told once in 10 minutes)"
    }
})
