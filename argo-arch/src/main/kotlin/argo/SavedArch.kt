package argo

import argo.boundary.Transparent
import argo.insides.Insides
import jason.architecture.AgArch
import java.util.logging.Logger

/**
 * Replaces [arch] when Java's serialization writes an agent, since ports and threads cannot be written. After the agent has been read back,
 * its first cycle inserts a new architecture, without ports, before this object.
 */
internal class SavedArch(arch: Arch) : AgArch(), Transparent {
    private val type = arch.javaClass
    private var isReplaced = false

    init {
        Insides.nextArch[this] = arch.nextAgArch
        Insides.firstArch[this] = arch.firstAgArch
        setTS(arch.ts)
    }

    override fun reasoningCycleStarting() {
        if (isReplaced) return super.reasoningCycleStarting()
        isReplaced = true
        val arch = type.getConstructor().newInstance()
        firstAgArch.insertAgArch(arch)
        arch.init()
        ts.ag.buf(ArrayList()) // the agent perceives nothing yet
        val log = Logger.getLogger("${Arch::class.java.name}.$agName")
        log.info("the agent goes on from its serialized form: it has no ports and no filter")
        arch.reasoningCycleStarting()
    }
}
