package argo.behaviour

import argo.testkit.AgentSetUp
import argo.testkit.TestAgent
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText

internal class Project(private val directory: Path) {
    fun file(name: String, text: String) = directory.resolve(name).apply { parent.createDirectories() }.writeText(text)

    fun filter(name: String, rules: String, attributes: String = "") =
        file("filters/$name.xml", "<?xml version=\"1.0\"?>\n<PerceptionFilter $attributes>$rules</PerceptionFilter>\n")

    fun agent(program: String, setUp: AgentSetUp.() -> Unit = {}): TestAgent {
        file("bob.asl", program)
        return argo.testkit.agent(directory.resolve("bob.asl"), setUp)
    }
}
