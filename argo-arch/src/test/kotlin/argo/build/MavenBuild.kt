package argo.build

import org.w3c.dom.Element
import java.nio.file.Path
import javax.xml.parsers.DocumentBuilderFactory

/** Reads what the Maven build under [root] declares. */
fun mavenBuild(root: Path): Build {
    val parent = Pom(root.resolve("pom.xml"))
    val properties = parent.properties + ("project.version" to parent.text("version"))
    val shared = parent.dependencies(properties)
    return Build(
        group = parent.text("groupId"),
        version = parent.text("version"),
        java = properties.getValue("maven.compiler.release"),
        kotlin = properties.getValue("kotlin.version"),
        kotlinJvmTarget = parent.first("jvmTarget").textContent,
        newestJason = properties.getValue("newest-jason.version"),
        dokka = properties.getValue("dokka.version"),
        libraries = parent.all("module").map { it.textContent }.filter { "maven.install.skip" !in Pom(root.resolve("$it/pom.xml")).properties },
        modules = parent.all("module").map { it.textContent }.associateWith { module ->
            val pom = Pom(root.resolve("$module/pom.xml"))
            shared + pom.dependencies(properties) + pom.processors(properties)
        },
    )
}

private class Pom(file: Path) {
    private val root = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile()).documentElement

    val properties: Map<String, String> =
        root.children("properties").flatMap { it.children() }.associate { it.tagName to it.textContent }

    fun text(tag: String): String = root.children(tag).single().textContent

    fun all(tag: String): List<Element> = root.getElementsByTagName(tag).let { nodes -> (0 until nodes.length).map { nodes.item(it) as Element } }

    fun first(tag: String): Element = all(tag).first()

    /** The module's own dependencies; Kotlin's standard library is left out, which Gradle's plugin adds unasked. */
    fun dependencies(properties: Map<String, String>): Set<Dependency> =
        root.children("dependencies").flatMap { it.children("dependency") }
            .map { it.dependency(properties, it.children("scope").singleOrNull()?.textContent ?: "compile") }
            .filter { it.coordinates != "org.jetbrains.kotlin:kotlin-stdlib" }.toSet()

    fun processors(properties: Map<String, String>): Set<Dependency> =
        all("annotationProcessorPaths").flatMap { it.children("path") }.map { it.dependency(properties, "processor") }.toSet()
}

private fun Element.children(tag: String? = null): List<Element> =
    (0 until childNodes.length).map { childNodes.item(it) }.filterIsInstance<Element>().filter { tag == null || it.tagName == tag }

private fun Element.dependency(properties: Map<String, String>, scope: String): Dependency {
    fun value(tag: String) = children(tag).single().textContent.replace(Regex("""\$\{(.+)}""")) { properties.getValue(it.groupValues[1]) }
    // of a multiplatform library Gradle finds the -jvm artifact by itself, but the POMs that it publishes are read by Maven too
    return Dependency(scope, "${value("groupId")}:${value("artifactId").removeSuffix("-jvm")}", value("version"))
}
