package argo.behaviour

import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

/** A project in [directory]: files beside its agent, which is called bob. */
internal class Project(private val directory: Path) {
    /** Writes a file, in place of one that an earlier test has written. */
    fun file(name: String, text: String) = directory.resolve(name).apply { parent.createDirectories() }.writeText(text)

    /** Writes the filter [name] with [rules]; [attributes] are those of the root. */
    fun filter(name: String, rules: String, attributes: String = "") =
        file("filters/$name.xml", "<?xml version=\"1.0\"?>\n<PerceptionFilter $attributes>$rules</PerceptionFilter>\n")

    /** Starts bob with [program]. */
    fun agent(program: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent {
        file("bob.asl", program)
        return argo.testkit.agent(directory.resolve("bob.asl"), setUp)
    }
}
