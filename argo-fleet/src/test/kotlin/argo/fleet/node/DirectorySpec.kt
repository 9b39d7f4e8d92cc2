package argo.fleet.node

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class DirectorySpec : FunSpec({
    fun whole(vararg agents: String) = RosterNews(isWhole = true, came = agents.toSet())

    val directory = Directory("base", planned = mapOf("scout" to listOf("scout1")), hosts = setOf("base", "scout1", "scout2"))
        .with("base", whole("boss"))
        .with("scout1", whole("scout", "guest"))

    test("an agent is found on the computer in touch that has it") {
        directory.with(setOf("base", "scout1")).run {
            find("boss") shouldBe Place.Here
            find("guest") shouldBe Place.There("scout1")
            find("nobody") shouldBe Place.Unknown
            names shouldBe setOf("boss", "scout", "guest")
        }
    }

    test("an agent whose computer is out of touch is off, and not among the names") {
        directory.find("guest") shouldBe Place.Off(listOf("scout1"))
        directory.names shouldBe setOf("boss")
    }

    test("an agent of the project is off before its computer has come") {
        Directory("base", planned = mapOf("scout" to listOf("scout1"))).find("scout") shouldBe Place.Off(listOf("scout1"))
    }

    test("a computer is met when it is in touch and has told its agents") {
        val now = directory.with(setOf("base", "scout1", "scout2"))
        listOf("base", "scout1", "scout2").map(now::isMet) shouldBe listOf(true, true, false)
        directory.isMet("scout1") shouldBe false
        unreachable("x", Place.Off(listOf("scout2")), now).message shouldBe "x cannot be reached: scout2 has not told its agents yet"
        unreachable("x", Place.Off(listOf("scout2")), directory).message shouldBe "x cannot be reached: scout2 is off"
    }

    test("changes of a roster add up, and a whole one replaces them") {
        val changed = directory.with(setOf("base", "scout1")).with("scout1", RosterNews(came = setOf("new"), gone = setOf("guest")))
        changed.names shouldBe setOf("boss", "scout", "new")
        changed.with("scout1", whole("other")).names shouldBe setOf("boss", "other")
    }

    test("services are those of computers in touch, and withdrawn ones are gone") {
        val offer = Offer("scout", "watch")
        val offering = directory.with("scout1", RosterNews(offered = setOf(offer)))
        offering.offers shouldBe emptySet()
        offering.with(setOf("base", "scout1")).offers shouldBe setOf(offer)
        offering.with(setOf("base", "scout1")).with("scout1", RosterNews(withdrawn = setOf(offer))).offers shouldBe emptySet()
    }

    test("of equal names this computer's agent comes first, then that of the least computer") {
        val twice = directory.with("scout2", whole("guest", "boss")).with(setOf("base", "scout1", "scout2"))
        twice.find("boss") shouldBe Place.Here
        twice.find("guest") shouldBe Place.There("scout1")
    }

    test("all computers of the project are known, and those that have come") {
        directory.with(setOf("base", "stranger")).computers shouldBe setOf("base", "scout1", "scout2", "stranger")
    }
})
