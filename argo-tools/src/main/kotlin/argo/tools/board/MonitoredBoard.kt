package argo.tools.board

import argo.links.BoardLink
import argo.links.Wish
import javino.PerceptsRequest
import javino.PortTimeoutException
import javino.link.Link

/** A board whose messages `monitor` shows. */
internal interface MonitoredBoard {
    /** True if each message needs a request; false if the board sends messages unasked. */
    val isAsked: Boolean

    /** The protocol's version, or the scheme of a port on no line. */
    val speaks: String

    /** A sentence that contains [speaks]. */
    val spoken: String get() = "the board speaks $speaks"

    /** The number of damaged frames, which were dropped. */
    val damaged: Long get() = 0

    /**
     * Returns the next message.
     *
     * @throws PortTimeoutException if no message comes in time
     */
    fun next(): String

    fun kinds(): DescribedKinds
}

internal class JavinoBoard(private val link: Link, override val isAsked: Boolean, private val timeoutMs: Int) : MonitoredBoard {
    override val speaks get() = versionSpoken(link.protocol())
    override val damaged get() = link.corruptFrames()

    override fun next(): String = (if (isAsked) link.request(PerceptsRequest.ALL, timeoutMs) else link.listen(timeoutMs)).text()

    override fun kinds() = DescribedKinds.of(link, timeoutMs)
}

/** A board without a serial line, such as a ROS robot. The board sends messages unasked, at an interval. */
internal class LinkedBoard(private val link: BoardLink, intervalMs: Int, private val timeoutMs: Int) : MonitoredBoard {
    override val isAsked get() = false
    override val speaks = link.port.substringBefore(':')
    override val spoken get() = "the messages came over $speaks" // perhaps from a robot, which is no board

    init {
        link.wants(Wish(true, intervalMs, null))
    }

    override fun next(): String = link.listen(timeoutMs)?.text
        ?: throw PortTimeoutException(link.port, "port ${link.port} is there, and has had nothing to say for $timeoutMs ms")

    override fun kinds() = DescribedKinds.NONE
}
