package argo.fleet.cluster

import org.jgroups.Address
import org.jgroups.Event
import org.jgroups.conf.ClassConfigurator
import org.jgroups.protocols.VERIFY_SUSPECT

/**
 * Asks suspected members for a sign before they are given up. Its thread ends when nobody is suspected, while that of JGroups' newer
 * protocol wakes all the time. JGroups' TCP hands lists over that cannot be changed, which JGroups' own class does not expect.
 */
internal class Verification : VERIFY_SUSPECT() {
    init {
        setId<VERIFY_SUSPECT>(ClassConfigurator.getProtocolId(VERIFY_SUSPECT::class.java))
    }

    override fun up(event: Event): Any? =
        super.up(if (event.type == Event.SUSPECT) Event(Event.SUSPECT, ArrayList<Address>(event.getArg<Collection<Address>>())) else event)
}
