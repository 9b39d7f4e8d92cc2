package argo.build

import org.w3c.dom.Element
import java.nio.file.Path
import javax.xml.parsers.DocumentBuilderFactory

/** Reads the declarations of the Maven build under [root]. */
fun mavenBuild(root: Path): Build {
    val parent = pom(root)
    val properties = parent.properties() + ("project.version" to parent.value("version"))
    val managed = parent.child("dependencyManagement")!!.dependencies()
        .associate { it.coordinates() to it.value("version").resolved(properties) }
    val modules = parent.all("module").map { it.textContent }
    fun dependency(element: Element, scope: String): Dependency {
        val own = element.child("version")?.textContent?.resolved(properties)
        return Dependency(scope, element.coordinates(), own ?: managed.getValue(element.coordinates()))
    }

    fun dependencies(pom: Element): List<Dependency> = (listOf(pom) + pom.all("profile")).flatMap { it.dependencies() }
        .filter { it.child("type") == null } // of type pom: no library, but a module that is built before
        .map { dependency(it, it.child("scope")?.textContent ?: "compile") }
        .filter { it.coordinates != "org.jetbrains.kotlin:kotlin-stdlib" } // Gradle's plugin adds it unasked

    return Build(
        group = parent.value("groupId"),
        versions = (parent.properties() + pom(root.resolve("format")).properties() + ("argo.version" to parent.value("version")))
            .filterKeys { it.endsWith(".version") }.mapKeys { (name, _) -> name.removeSuffix(".version") },
        java = properties.getValue("maven.compiler.release"),
        kotlinJvmTarget = parent.all("jvmTarget").single().textContent,
        libraries = modules.filter { "maven.install.skip" !in pom(root.resolve(it)).properties() },
        serialized = modules.filter { module -> pom(root.resolve(module)).all("compilerPlugins").isNotEmpty() },
        modules = modules.associateWith { module ->
            val pom = pom(root.resolve(module))
            val processors = pom.all("annotationProcessorPaths").flatMap { it.all("path") }.map { dependency(it, "processor") }
            (dependencies(parent) + dependencies(pom) + processors).toSet()
        },
    )
}

private fun pom(folder: Path): Element =
    DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(folder.resolve("pom.xml").toFile()).documentElement

private fun Element.properties(): Map<String, String> = child("properties")?.children().orEmpty().associate { it.tagName to it.textContent }

private fun Element.dependencies(): List<Element> = child("dependencies")?.children().orEmpty()

// of a multiplatform library Gradle finds the -jvm artifact by itself, but the POMs that it publishes are read by Maven too
private fun Element.coordinates(): String = "${value("groupId")}:${value("artifactId").removeSuffix("-jvm")}"

private fun Element.all(tag: String): List<Element> =
    getElementsByTagName(tag).let { nodes -> (0 until nodes.length).map { nodes.item(it) as Element } }

private fun Element.children(): List<Element> = (0 until childNodes.length).map { childNodes.item(it) }.filterIsInstance<Element>()

private fun Element.child(tag: String): Element? = children().singleOrNull { it.tagName == tag }

private fun Element.value(tag: String): String = checkNotNull(child(tag)) { "no <$tag> in <$tagName>" }.textContent

private fun String.resolved(properties: Map<String, String>): String =
    replace(Regex("""\$\{(.+)}""")) { properties.getValue(it.groupValues[1]) }
