package argo.fleet.trial

import java.net.InetAddress
import java.net.ServerSocket

/** The ports are below those of outgoing connections, which the operating system could use first. */
private val PORTS = 20_000..31_999

/** Returns [count] free ports of the loopback interface. The ports are random, so that parallel tests get different ports. */
fun freePorts(count: Int): List<Int> = PORTS.shuffled().asSequence().filter(::isFree).take(count).toList()

private fun isFree(port: Int) = runCatching { ServerSocket(port, 1, InetAddress.getLoopbackAddress()).close() }.isSuccess
