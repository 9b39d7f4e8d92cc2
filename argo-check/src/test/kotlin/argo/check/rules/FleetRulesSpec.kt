package argo.check.rules

import argo.check.findings.Level
import io.kotest.core.spec.style.FunSpec
import io.kotest.datatest.withData
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe

class FleetRulesSpec : FunSpec({
    val root = tempdir().toPath()
    val hosts = "hosts([base(\"10.8.0.1\"), \"scout-1\", host(\"rasp-pi\",\"10.8.0.12:4800\")])"

    fun found(infrastructure: String, agents: String, program: String = "") =
        findingsIn(root, "m.mas2j" to "MAS m { $infrastructure agents: $agents }", "a.asl" to program, "b.asl" to "")
            .filter { it.rule == "fleet" }

    test("computers that the fleet has are no finding, also if their names are no words, or nobody names them") {
        val agents = "a at \"base, rasp-pi\"; b [argo_fleet=\"agents\"] at \"scout-1\";"
        found("infrastructure: Fleet($hosts, insecure)", agents).shouldBeEmpty()
        found("infrastructure: Fleet", "a at \"base\";").shouldBeEmpty()
        found("infrastructure: Jade", "a at \"base\"; b;").shouldBeEmpty()
    }

    context("a project that the fleet would refuse is an error") {
        withData(
            nameFn = { it.third },
            Triple(hosts, "a at \"scout_1\";", "agent a is at scout_1, which is none of the fleet's hosts"),
            Triple(hosts, "a at \"base, rasp-pj\";", "agent a is at rasp-pj, which is none of the fleet's hosts"),
            Triple(hosts, "a;", "agent a is at no computer"),
            Triple("hosts([base,base(\"10.8.0.2\")])", "a at \"base\";", "two computers are called base"),
            Triple("hots([base])", "a at \"base\";", "hots is no option of Fleet"),
            Triple("insecure", "a at \"base, scout\";", "agent a is at several computers of a fleet without hosts"),
        ) { (options, agents, what) ->
            found("infrastructure: Fleet($options)", agents).map { it.level to it.what } shouldBe listOf(Level.ERROR to what)
        }
    }

    test("a slip in a computer's name is told with the name that may be meant") {
        found("infrastructure: Fleet(hosts([base,scout]))", "a at \"bse\";").single().remedy shouldBe "did you mean base?"
    }

    test("an agent with boards that outlives its computer is warned of") {
        val fleet = "infrastructure: Fleet($hosts)"
        val moving = found(fleet, "a agentArchClass argo.Arch at \"base, rasp-pi\";", "!g. +!g <- argo.port(ttyACM0).")
        moving.map { it.level to it.what } shouldBe
            listOf(Level.WARNING to "agent a uses boards, and runs on another computer when its own goes")
        found(fleet, "a agentArchClass argo.Arch at \"base\";", "!g. +!g <- argo.port(ttyACM0).").shouldBeEmpty()
    }

    test("computers of agents without a fleet are warned of, once") {
        found("", "a at \"base\"; b at \"base\";").map { it.level to it.what } shouldBe listOf(Level.WARNING to "at \"base\" has no effect")
        found("infrastructure: Local", "a at \"base\";").size shouldBe 1
    }
})
