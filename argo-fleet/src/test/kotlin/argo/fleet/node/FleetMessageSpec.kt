package argo.fleet.node

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.choice
import io.kotest.property.arbitrary.constant
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll

class FleetMessageSpec : FunSpec({
    val messages = listOf(
        Say("mid1", "samid2", "tell", "a", "b", "x(\"ä\\n\")[source(a)]", 3),
        Say(null, null, "achieve", "a", "b", "g"),
        RosterNews(isWhole = true, came = setOf("a", "b"), offered = setOf(Offer("a", "sells(x)"))),
        RosterNews(gone = setOf("a"), withdrawn = setOf(Offer("a", "s")), unable = setOf("m")),
        RosterNews(able = setOf("m")),
        Known(mapOf("base" to -7)),
        Unanswered("samid2", "a", "not_sendable", "it is a Java object"),
        Kill("a", "b", 100),
        Stop(0, true, 3),
        Claim("a", 1, 2),
        Grant("a", 1, 2, false),
        MindNews("a", 1, 2, "x.\n!g."),
    )

    test("each message is read as it was written") {
        messages.forEach { FleetMessage.decode(it.encode()) shouldBe it }
    }

    test("a message of another version is refused by its first byte") {
        val bytes = messages.first().encode().also { it[0] = 2 }
        shouldThrow<UnreadableMessage> { FleetMessage.decode(bytes) }.message shouldContain "it is of format 2"
    }

    test("any other bytes are refused with a reason, and nothing else is thrown") {
        val garbage = Arb.byteArray(Arb.int(0..200), Arb.byte()).map { it.apply { if (size > 0) this[0] = FleetMessage.FORMAT } }
        val halves = Arb.int(0..200).map { length -> messages.first().encode().let { it.copyOf(minOf(length, it.size - 1)) } }
        val strange = Arb.constant(byteArrayOf(FleetMessage.FORMAT) + "{\"type\":\"java.lang.Runtime\"}".encodeToByteArray())
        checkAll(Arb.choice(garbage, halves, strange)) { bytes -> shouldThrow<UnreadableMessage> { FleetMessage.decode(bytes) } }
    }
})
