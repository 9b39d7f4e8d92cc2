package argo.fleet.cluster

import io.kotest.assertions.nondeterministic.continually
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThan
import org.jgroups.JChannel
import org.jgroups.Message
import org.jgroups.protocols.DISCARD
import org.jgroups.protocols.FailureDetection
import org.jgroups.protocols.SHARED_LOOPBACK
import org.jgroups.protocols.SHARED_LOOPBACK_PING
import org.jgroups.protocols.UNICAST3
import org.jgroups.protocols.pbcast.GMS
import org.jgroups.protocols.pbcast.NAKACK2
import org.jgroups.protocols.pbcast.STABLE
import org.jgroups.stack.Protocol
import java.util.concurrent.atomic.AtomicInteger
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.time.Duration.Companion.seconds

private val JGROUPS = Logger.getLogger("org.jgroups")

/** Members of a group in one program, in real time with short rounds. */
@Tags("Thorough")
class SignsOfLifeSpec : FunSpec({
    beforeSpec { JGROUPS.level = Level.OFF }

    /** Counts the signs of life of a member. A sign to all counts once for each other member. */
    class Counting(private val members: Int) : Protocol() {
        val signs = AtomicInteger()

        override fun down(message: Message): Any? {
            val isSign = message.headers.values.any { it is FailureDetection.HeartbeatHeader }
            if (isSign) signs.addAndGet(if (message.dest == null) members - 1 else 1)
            return down_prot.down(message)
        }
    }

    class Members(count: Int) : AutoCloseable {
        private val net = List(count) { DISCARD() }
        private val counting = List(count) { Counting(count) }
        private val channels = List(count) { place ->
            val signs = SignsOfLife().setInterval(100).setTimeout(200)
            JChannel(
                SHARED_LOOPBACK(), SHARED_LOOPBACK_PING(), net[place], counting[place], signs, Verification().setTimeout(100), NAKACK2(),
                UNICAST3(), STABLE(), GMS().printLocalAddress(false).setViewAckCollectionTimeout(200),
            ).name("$place").connect("signs")
        }
        val signs get() = counting.sumOf { it.signs.get() }

        fun views(): List<List<String>> = channels.map { channel -> channel.view.members.map { "$it" } }

        fun unplug(places: IntRange) = places.forEach { net[it].discardAll(true) }

        override fun close() {
            net.forEach { it.discardAll(true) }
            channels.forEach(JChannel::close)
        }
    }

    suspend fun missed(gone: IntRange) = Members(14).use { members ->
        val rest = (0..13) - gone
        members.unplug(gone)
        eventually(60.seconds) {
            rest.map { members.views()[it].map(String::toInt).sorted() }.distinct().shouldContainExactly(listOf(rest))
        }
    }

    test("of a large group, one of the younger members is missed") { missed(9..9) }

    test("of a large group, the oldest member is missed") { missed(0..0) }

    test("of a large group, more members than those that exchange signs with all are missed at once") { missed(0..6) }

    test("in a large group nobody is missed that is there, for a few signs") {
        Members(14).use { members ->
            val before = members.signs
            continually(2.seconds) { members.views().map { it.size }.distinct().shouldContainExactly(14) }
            members.signs - before shouldBeLessThan 20 * 14 * 13 / 2
        }
    }
})
