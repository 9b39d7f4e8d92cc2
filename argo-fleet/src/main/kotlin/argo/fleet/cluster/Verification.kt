package argo.fleet.cluster

import org.jgroups.Address
import org.jgroups.Event
import org.jgroups.conf.ClassConfigurator
import org.jgroups.protocols.VERIFY_SUSPECT

/**
 * Asks suspected members for a sign before they are given up. Its thread ends when nobody is suspected, while the thread of JGroups' newer
 * protocol wakes all the time. Copies each list of suspects, since JGroups' own class changes it, and TCP's is immutable.
 */
internal class Verification : VERIFY_SUSPECT() {
    init {
        setId<VERIFY_SUSPECT>(ClassConfigurator.getProtocolId(VERIFY_SUSPECT::class.java))
    }

    override fun up(event: Event): Any? =
        super.up(if (event.type == Event.SUSPECT) Event(Event.SUSPECT, ArrayList<Address>(event.getArg<Collection<Address>>())) else event)
}
