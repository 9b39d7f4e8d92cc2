package argo.ros

import argo.ros.bridge.BridgeSocket
import argo.ros.mapping.Credentials
import argo.ros.mapping.Mapping
import javino.LineClock
import java.net.URI

internal fun RosLink.Companion.open(
    port: String,
    address: URI,
    mapping: Mapping,
    isPaced: Boolean,
    clock: LineClock,
    credentials: Credentials = Credentials(),
): RosLink = over(port, mapping, isPaced, clock) { BridgeSocket.connect(port, address, it, credentials) }
