package argo.fleet.cluster

import org.jgroups.Address
import org.jgroups.Event
import org.jgroups.conf.ClassConfigurator
import org.jgroups.protocols.VERIFY_SUSPECT

/**
 * Asks suspected members for a sign before they are given up. The thread of this protocol ends when no member is suspected. The thread of
 * JGroups' newer protocol wakes all the time. Copies each list of suspects. JGroups' own class changes the list, and that of TCP is
 * immutable.
 */
internal class Verification : VERIFY_SUSPECT() {
    init {
        setId<VERIFY_SUSPECT>(ClassConfigurator.getProtocolId(VERIFY_SUSPECT::class.java))
    }

    override fun up(event: Event): Any? =
        super.up(if (event.type == Event.SUSPECT) Event(Event.SUSPECT, ArrayList<Address>(event.getArg<Collection<Address>>())) else event)
}
