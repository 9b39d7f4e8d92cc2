package argo.fleet.cluster

import java.io.FilterInputStream
import java.io.InputStream

/**
 * Tells a thread the name of the computer whose connection it reads; that computer has proved its name at the beginning of the connection.
 * JGroups reads each connection on its own thread, which hands the messages over without the connection.
 */
internal object Origin {
    private val names = ThreadLocal<String>()

    /** The computer whose connection the calling thread has read last; null: the thread has read none. */
    val current: String? get() = names.get()

    /** Wraps [stream], whose bytes come from the computer [name], so that each read sets [current]. */
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
