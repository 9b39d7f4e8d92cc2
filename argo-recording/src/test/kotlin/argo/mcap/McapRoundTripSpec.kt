package argo.mcap

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempfile
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.long
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

private class Written(val channel: Int, val timeNs: Long, val data: ByteArray) {
    override fun toString() = "$channel@$timeNs: ${data.toList()}"
}

private val messages = Arb.list(
    arbitrary {
        Written(Arb.int(0..2).bind(), Arb.long(0L..1_000L).bind(), Arb.byteArray(Arb.int(0..60), Arb.byte()).bind())
    },
    0..60,
)

private fun McapWriter.channels() {
    val schema = schema("argo.Test", """{"type":"object"}""")
    listOf("/a", "/b", "/ü").forEach { channel(it, schema, mapOf("agent" to it)) }
}

class McapRoundTripSpec : FunSpec({
    test("what is written is read: messages in their order, channels, schemas, attachments and metadata") {
        val file = tempfile(suffix = ".mcap").toPath()
        val bytes = Arb.byteArray(Arb.int(0..300), Arb.byte())
        checkAll(200, messages, Arb.int(1..2_000), Arb.string(0..20), bytes) { all, chunk, text, data ->
            writeMcap(file, chunk) {
                metadata("versions", mapOf("argo" to text, "java" to "17"))
                attachment(text, "text/plain", data, 7)
                channels()
                all.forEach { message(it.channel, it.timeNs, it.timeNs, it.data) }
            }
            McapReader(file).use { read ->
                read.problems.shouldBeEmpty()
                read.library shouldBe "argo"
                read.channels.map { it.topic } shouldBe listOf("/a", "/b", "/ü")
                read.channels.map { it.metadata } shouldBe listOf("/a", "/b", "/ü").map { mapOf("agent" to it) }
                read.channels.map { it.schema } shouldBe List(3) { McapSchema(1, "argo.Test", "jsonschema", """{"type":"object"}""") }
                read.metadata shouldBe listOf(McapMetadata("versions", mapOf("argo" to text, "java" to "17")))
                read.attachments.map { Triple(it.name, it.mediaType, it.timeNs) } shouldBe listOf(Triple(text, "text/plain", 7L))
                read.attachments.single().data.toList() shouldBe data.toList()
                read.messageCount shouldBe all.size
                read.times shouldBe all.map { it.timeNs }.let { times -> times.minOrNull()?.rangeTo(times.max()) }
                read.messages().map { Triple(it.channel.id, it.logTimeNs, it.data.toList()) }.toList() shouldBe
                    all.map { Triple(it.channel, it.timeNs, it.data.toList()) }
                read.messages().groupBy { it.channel.id }.values.forEach { ofOne ->
                    ofOne.map { it.sequence } shouldBe ofOne.indices.map(Int::toLong)
                }
            }
        }
    }

    test("messages are found by time and topic") {
        val file = tempfile(suffix = ".mcap").toPath()
        checkAll(100, messages, Arb.int(1..500), Arb.long(0L..1_000L), Arb.long(0L..1_000L)) { all, chunk, from, until ->
            writeMcap(file, chunk) {
                channels()
                all.forEach { message(it.channel, it.timeNs, it.timeNs, it.data) }
            }
            McapReader(file).use { read ->
                read.messages(from, until, setOf("/a", "/ü")).map { it.channel.id to it.logTimeNs }.toList() shouldBe
                    all.filter { it.channel != 1 && it.timeNs in from until until }.map { it.channel to it.timeNs }
            }
        }
    }
})
