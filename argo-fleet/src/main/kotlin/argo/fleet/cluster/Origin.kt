package argo.fleet.cluster

import java.io.FilterInputStream
import java.io.InputStream

/**
 * Gives a thread the name of the computer whose connection it reads. The computer has proved its name at the start of the connection.
 * JGroups reads each connection on a thread of its own. The reading thread passes on the messages without the connection.
 *
 * `JGroupsGroup` leaves out messages under the name of another computer. `Fleet` refuses messages of agents that do not run on the
 * computer.
 */
internal object Origin {
    private val names = ThreadLocal<String>()

    /** The computer whose connection the calling thread read last, or null if it has read none. */
    val current: String? get() = names.get()

    /** Wraps [stream], which comes from the computer [name]. Each read then sets [current]. */
    fun stream(name: String, stream: InputStream): InputStream = object : FilterInputStream(stream) {
        override fun read(): Int {
            names.set(name)
            return super.read()
        }

        override fun read(into: ByteArray, offset: Int, length: Int): Int {
            names.set(name)
            return super.read(into, offset, length)
        }
    }
}
