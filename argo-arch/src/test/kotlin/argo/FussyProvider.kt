package argo

import argo.connecting.Ports
import javino.LineSettings
import javino.PortException
import javino.Transport
import javino.TransportProvider
import javino.Transports

/** Ports that may refuse to be opened. If [refusal] returns null, `fussy:robot` is `sim:robot`, or the line that [opening] makes. */
class FussyProvider : TransportProvider {
    override fun scheme() = "fussy"

    override fun open(address: String, line: LineSettings): Transport {
        refusal("fussy:$address", line)?.let { throw it }
        return opening(address, line)
    }

    override fun ports() = listOf<String>()

    override fun canonicalName(address: String) = "sim:$address"

    override fun isPresent(address: String) = Transports.isPresent("sim:$address")

    companion object {
        /** Returns the exception with which opening a port at a rate fails, or null. */
        @Volatile
        var refusal: (String, LineSettings) -> PortException? = { _, _ -> null }

        @Volatile
        var opening: (String, LineSettings) -> Transport = ::openSimulated

        fun openSimulated(address: String, line: LineSettings): Transport = Transports.open("sim:$address", line)
    }
}
