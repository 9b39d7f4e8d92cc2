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
 * Suspects a member without a sign of life for two rounds. The suspicion takes at most three rounds. In a small group, each member sends
 * signs to every other. In a larger group, the [OLDEST] oldest members exchange signs with all. The other members exchange signs only with
 * the oldest. These signs are enough, since the oldest living member tells all others about losses. All of the oldest may be lost. A member
 * that misses one of them therefore asks everybody for a sign. The oldest answering member is found within three more rounds.
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

    /** True if this member exchanges signs with all, because it is one of the oldest or misses a member. */
    private fun isForAll() = local_addr in oldest || has_suspected_mbrs

    /** Sends a sign to a member, or to all if [to] is null. */
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

    /** Answers a member that asks everybody for a sign. Does nothing if this member sends signs to all anyway. */
    private fun answer(message: Message) {
        val isQuestion = message.dest == null && HAS_HEADER.test(message) && message.src in all && message.src !in oldest
        if (isQuestion && !isForAll()) send(message.src)
    }

    override fun <T> needsToBeSuspected(member: Address, value: T): Boolean {
        if (isForAll() || member in oldest) return super.needsToBeSuspected(member, value)
        update(member, false, false) // this member gets no signs from the asking member
        return false
    }

    private companion object {
        const val SMALL = 10
        const val OLDEST = 3
    }
}
