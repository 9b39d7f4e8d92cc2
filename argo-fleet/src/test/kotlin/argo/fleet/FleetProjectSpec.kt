package argo.fleet

import argo.fleet.cluster.ClusterSettings
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.datatest.withData
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import jason.mas2j.MAS2JProject
import jason.mas2j.parser.mas2j
import kotlin.io.path.writeText

class FleetProjectSpec : FunSpec({
    fun project(infrastructure: String, agents: String = "a at \"base\";"): MAS2JProject =
        mas2j("MAS garden { infrastructure: $infrastructure agents: $agents }".byteInputStream()).mas().apply { setupDefault() }

    fun fleet(infrastructure: String, agents: String = "a at \"base\";") = FleetProject(project(infrastructure, agents))

    test("computers have addresses and ports of their own, or those of the fleet") {
        val fleet = fleet("Fleet(name(meadow), hosts([base(\"127.0.0.1\"),scout1(\"127.0.0.1:4800\"),scout2(\"[::1]:4801\")]), port(4799))")
        fleet.name shouldBe "meadow"
        fleet.hosts.mapValues { (_, address) -> address.port } shouldBe mapOf("base" to 4799, "scout1" to 4800, "scout2" to 4801)
        fleet.settings("scout1", null).bind.port shouldBe 4800
    }

    test("a computer without an address has its own name as its host's") {
        fleet("Fleet(hosts([localhost]))", "a at \"localhost\";").hosts.getValue("localhost").address.isLoopbackAddress shouldBe true
    }

    test("a file that is no project is refused in one line, without a stack trace") {
        val file = tempdir().toPath().resolve("garden.mas2j")
        listOf(
            "MAS garden { infrastructure: Fleet(insecure)) }" to "it is no project: Encountered \" \")\" \") \"\" at line 1, column 45",
            "MAS garden { infrastructure: Fleet(hosts([])) }" to "the list of hosts is empty",
            "MAS garden { infrastructure: Fleet(hosts([rasp-pi])) }" to "a name with a hyphen stands in quotes",
        ).forEach { (text, reason) ->
            file.writeText(text)
            shouldThrow<FleetProjectException> { FleetMas().read("$file") }.message shouldContain reason
        }
    }

    test("a name in upper case without quotes is refused in one line") {
        shouldThrow<FleetProjectException> { fleet("Fleet(hosts([Base(\"127.0.0.1\")]))") }.message shouldContain
            Regex("Encountered .* at line 1, column 13\\.; a name in upper case stands in quotes, as host\\(\"Pi\",\"10.8.0.1\"\\)$")
    }

    test("a name that is no word of AgentSpeak stands in quotes") {
        val hosts = "host(\"rasp-pi\",\"127.0.0.1:4800\"),\"localhost\",host(\"127.0.0.1:4801\")"
        val fleet = fleet("Fleet(hosts([$hosts]))", "a at \"rasp-pi\";")
        fleet.hosts.mapValues { (_, address) -> address.port } shouldBe mapOf("rasp-pi" to 4800, "localhost" to 4711, "host" to 4801)
        fleet.settings("rasp-pi", null).here shouldBe "rasp-pi"
    }

    test("without hosts a fleet has the project's name, and listens on the loopback interface") {
        val settings = fleet("Fleet").settings("base", null)
        settings.fleet shouldBe "garden"
        settings.hosts shouldBe emptyMap()
        settings.bind.address.isLoopbackAddress shouldBe true
        settings.bind.port shouldBe ClusterSettings.DEFAULT_PORT
    }

    test("agents are at their computers, several of a kind by numbers") {
        val fleet = fleet("Fleet(hosts([base(\"127.0.0.1:1\"),s(\"127.0.0.1:2\")]))", "a at \"base, s\"; b #2 at \"s\";")
        fleet.planned shouldBe mapOf("a" to listOf("base", "s"), "b1" to listOf("s"), "b2" to listOf("s"))
        fleet.agents.filter { it.isMovable }.map { it.name } shouldBe listOf("a")
    }

    context("a project is refused") {
        withData(
            nameFn = { (it, _) -> it },
            "Local" to "infrastructure: Local",
            "Fleet(hots([base]))" to "hots is no option of Fleet",
            "Fleet(name(a), name(b))" to "name twice",
            "Fleet(insecure, tls(\"x\"))" to "of which only one can be meant",
            "Fleet(insecure(no))" to "Fleet has insecure(no) where insecure, or nothing, is expected",
            "Fleet(port(70000))" to "a port from 1 to 65535",
            "Fleet(port(1,2))" to "port(…) with one argument",
            "Fleet(hosts(base))" to "hosts([base(\"10.8.0.1\")",
            "Fleet(hosts([base(\"127.0.0.1\",2)]))" to "a computer, as base(",
            "Fleet(hosts([base(\"127.0.0.1:0\")]))" to "a port is from 1",
            "Fleet(hosts([base(\"127.0.0.1\"),base(\"127.0.0.1\")]))" to "two computers are called base",
            "Fleet(hosts([other(\"127.0.0.1\")]))" to "agent a is at base, which is none of the hosts other",
        ) { (infrastructure, reason) ->
            shouldThrow<FleetProjectException> { fleet(infrastructure) }.message shouldContain reason
        }
    }

    test("an agent without a computer, and two of one name, are refused") {
        shouldThrow<FleetProjectException> { fleet("Fleet", "a;") }.message shouldContain "agent a is at no computer"
        shouldThrow<FleetProjectException> { fleet("Fleet", "a at \"base\"; a at \"scout\";") }.message shouldContain
            "two agents are called a"
        shouldThrow<FleetProjectException> { fleet("Fleet", "a at \"base, scout\";") }.message shouldContain "most computers have to agree"
    }

    test("an agent that outlives its computer, and has a file of one computer to go on from, is refused") {
        val hosts = "Fleet(hosts([base(\"127.0.0.1:1\"),s(\"127.0.0.1:2\")]))"
        shouldThrow<FleetProjectException> { fleet(hosts, "a [argo_resume=\"a.state\"] at \"base, s\";") }.message shouldContain
            "leave argo_resume out"
        fleet(hosts, "a [argo_resume=\"a.state\"] at \"base\";").planned shouldBe mapOf("a" to listOf("base"))
    }

    test("a computer that the project does not know is refused, with those that it knows") {
        val fleet = fleet("Fleet(hosts([base(\"127.0.0.1:1\"),s(\"127.0.0.1:2\")]))")
        shouldThrow<FleetProjectException> { fleet.settings("scout9", null) }.message shouldContain
            "there is no computer scout9 in this fleet; there are base, s"
        shouldThrow<FleetProjectException> { fleet.settings("base", "127.0.0.1") }.message shouldContain
            "base, 127.0.0.1:1, so --bind 127.0.0.1 has no meaning"
    }

    test("of the computers' addresses, only this one's has to be known") {
        val fleet = fleet("Fleet(hosts([base(\"127.0.0.1:1\"),s(\"no.such.host.invalid\")]))")
        fleet.settings("base", null).bind.port shouldBe 1
        shouldThrow<FleetProjectException> { fleet.settings("s", null) }.message shouldContain
            "the address of no.such.host.invalid is not known"
    }

    test("a fleet that others can reach has certificates, or says that it is insecure") {
        shouldThrow<FleetProjectException> { fleet("Fleet").settings("base", "0.0.0.0") }.message shouldContain "insecure"
        fleet("Fleet(insecure)").settings("base", "0.0.0.0").insecure shouldBe true
        fleet("Fleet(tls(\"keys\"), hosts([base(\"0.0.0.0\")]))").settings("base", null).certificates.toString() shouldBe "keys"
        shouldThrow<FleetProjectException> { fleet("Fleet(tls(\"keys\"))").settings("base", "0.0.0.0") }.message shouldContain
            "with certificates the fleet has to name its hosts"
    }
})
