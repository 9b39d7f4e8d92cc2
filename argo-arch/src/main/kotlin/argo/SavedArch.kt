package argo

import argo.boundary.Transparent
import argo.insides.Insides
import jason.architecture.AgArch
import java.util.logging.Logger

/**
 * Replaces [arch] in an agent that Java's serialization writes, since ports and threads cannot be written. When an agent is read back and
 * begins its first cycle, a new architecture of the same class, without ports, is put in front of this one.
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
