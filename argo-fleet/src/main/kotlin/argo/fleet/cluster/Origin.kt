package argo.fleet.cluster

import java.io.FilterInputStream
import java.io.InputStream

/**
 * Tells a thread the computer at the other end of the connection that it reads. That computer has proved its name at the beginning of the
 * connection. JGroups has a thread for each connection, which reads messages and hands them over, but does not name the connection.
 */
internal object Origin {
    private val names = ThreadLocal<String>()

    /** The computer of the connection that the calling thread has read last; null: it has read none. */
    val current: String? get() = names.get()

    /** Returns [stream], whose bytes come from the computer [name]. */
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
