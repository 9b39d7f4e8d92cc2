package argo.tools.command

import java.io.File
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.toPath

/**
 * The parts of ARGO that belong to [jar], its `argo.jar`. In a release, they are in the folder of the jar. In a source tree, they are in
 * Maven's output folders.
 */
internal class Installation(jar: Path) {
    private val file = jar.toAbsolutePath().normalize()
    private val release = file.resolveSibling("samples")
    private val releasedJars = if (release.isDirectory()) release.listDirectoryEntries("*.jar") else emptyList()

    /**
     * Returns the class path of [module], which is `samples` or `experiment`. `samples` and `experiment` need Jason, so `argo.jar` does not
     * contain them.
     *
     * @throws ToolException if the module is missing
     */
    fun classPathOf(module: String): String {
        if (releasedJars.isNotEmpty()) return allReleased()
        val libraries = librariesOf(module) ?: throw ToolException(
            "the samples are not there. A release has them in the folder samples beside argo.jar (looked for: $release); " +
                "in the sources of ARGO, \"mvn package -Dmaven.test.skip=true\" builds them",
        )
        return outputOf(module).resolve("classes").toString() + File.pathSeparator + libraries
    }

    /** Returns the class path of the samples, with Jason and its libraries, or null if it is missing. */
    fun jason(): String? =
        if (releasedJars.any { it.name.startsWith(JASON) }) allReleased() else librariesOf("samples")?.takeIf { JASON in it }

    fun testKit(): Path? {
        val built = outputOf("argo-testkit").takeIf { it.isDirectory() }?.listDirectoryEntries("argo-testkit-*.jar").orEmpty()
        return file.resolveSibling("argo-testkit.jar").takeIf { it.isRegularFile() }
            ?: built.find { jar -> ASIDE.none { jar.name.endsWith(it) } }
    }

    private fun allReleased() = "$release${File.separator}*"

    private fun outputOf(module: String) = file.resolve("../../../$module/target").normalize()

    private fun librariesOf(module: String) = outputOf(module).resolve("run.classpath").takeIf { it.isRegularFile() }?.readText()?.trim()

    private companion object {
        const val JASON = "jason-interpreter"
        val ASIDE = listOf("-sources.jar", "-javadoc.jar")
    }
}

internal fun ownJar(): Path? =
    ToolCommand::class.java.protectionDomain.codeSource.location.toURI().toPath().takeIf { it.isRegularFile() }
