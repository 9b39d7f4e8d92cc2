package argo.fleet.cluster

import org.jgroups.Address
import org.jgroups.EmptyMessage
import org.jgroups.Message
import org.jgroups.View
import org.jgroups.conf.ClassConfigurator
import org.jgroups.protocols.FD_ALL3
import org.jgroups.protocols.FailureDetection
import org.jgroups.util.MessageBatch
import java.util.concurrent.TimeUnit
import kotlin.concurrent.withLock

/**
 * Suspects members without a sign of life for two rounds, within three rounds. In a small group, each member sends signs to each. In a
 * larger one the oldest members exchange signs with all, and the others with the oldest only: that suffices, since the oldest member that
 * lives tells all who has gone. A member that misses one of the oldest asks everybody for a sign, for the case that all of the oldest have
 * gone: so the oldest of those that answer is found within three further rounds.
 */
internal class SignsOfLife : FD_ALL3() {
    @Volatile
    private var all = emptySet<Address>()

    @Volatile
    private var oldest = emptySet<Address>()

    init {
        setId<FD_ALL3>(ClassConfigurator.getProtocolId(FD_ALL3::class.java))
    }

    override fun handleViewChange(view: View) {
        all = view.members.toSet()
        oldest = if (all.size <= SMALL) all else view.members.take(OLDEST).toSet()
        super.handleViewChange(view)
    }

    override fun startHeartbeatSender() = lock.withLock {
        if (!isHeartbeatSenderRunning) {
            heartbeat_sender = timer.scheduleWithFixedDelay(::sendSigns, 0, interval, TimeUnit.MILLISECONDS, false)
        }
    }

    private fun sendSigns() = if (isForAll()) send(null) else oldest.forEach(::send)

    /** Whether this member exchanges signs with all, as one of the oldest, or because it misses a member. */
    private fun isForAll() = local_addr in oldest || has_suspected_mbrs

    /** Sends a sign to a member; null: to all. */
    private fun send(to: Address?) {
        down_prot.down(EmptyMessage(to).setFlag(Message.TransientFlag.DONT_LOOPBACK).putHeader(id, FailureDetection.HeartbeatHeader()))
    }

    override fun up(message: Message): Any? {
        answer(message)
        return super.up(message)
    }

    override fun up(batch: MessageBatch) {
        batch.forEach(::answer)
        super.up(batch)
    }

    /** Answers a member that asks everybody, if it does not get this member's signs anyway. */
    private fun answer(message: Message) {
        val isQuestion = message.dest == null && HAS_HEADER.test(message) && message.src in all && message.src !in oldest
        if (isQuestion && !isForAll()) send(message.src)
    }

    override fun <T> needsToBeSuspected(member: Address, value: T): Boolean {
        if (isForAll() || member in oldest) return super.needsToBeSuspected(member, value)
        update(member, false, false) // no sign is due
        return false
    }

    private companion object {
        const val SMALL = 10
        const val OLDEST = 3
    }
}
