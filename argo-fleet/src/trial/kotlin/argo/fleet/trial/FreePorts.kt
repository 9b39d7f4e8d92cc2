package argo.fleet.trial

import java.net.InetAddress
import java.net.ServerSocket

/** These are below the ports of outgoing connections: the system could use such a port before the computer of a fleet does. */
private val PORTS = 20_000..31_999

/** Returns [count] ports of the loopback interface that are free, drawn so that two tests at a time have others. */
fun freePorts(count: Int): List<Int> = PORTS.shuffled().asSequence().filter(::isFree).take(count).toList()

private fun isFree(port: Int) = runCatching { ServerSocket(port, 1, InetAddress.getLoopbackAddress()).close() }.isSuccess
