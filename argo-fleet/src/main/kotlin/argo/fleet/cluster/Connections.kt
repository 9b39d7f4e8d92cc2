package argo.fleet.cluster

import org.jgroups.Address
import org.jgroups.conf.ClassConfigurator
import org.jgroups.protocols.TCP

/**
 * Closes the connections of members that leave. At each change of members, JGroups' own class closes those of all who are no members. So
 * of many computers that begin at a time, each that joins would cut off the others that are about to: they would connect to all anew, and
 * miss answers for which they wait.
 */
internal class Connections : TCP() {
    private var last = emptySet<Address>()

    init {
        setId<TCP>(ClassConfigurator.getProtocolId(TCP::class.java))
    }

    @Synchronized
    override fun retainAll(members: Collection<Address>) {
        val now = members.toSet()
        (last - now).forEach { srv.closeConnection(it, false) }
        last = now
    }
}
