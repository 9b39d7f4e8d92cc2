package argo.tools.samples

import argo.tools.command.ToolException
import java.io.File
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText

/**
 * Returns the class path of [module], the samples or the experiment, which are not in `argo.jar`, since they need Jason: a folder `samples`
 * beside [jar], which holds both in a release, or Maven's output in the source tree in which [jar] was built.
 *
 * @throws ToolException if there are none
 */
internal fun samplesClassPath(jar: Path, module: String): String {
    val file = jar.toAbsolutePath().normalize()
    val release = file.resolveSibling("samples")
    if (release.isDirectory() && release.listDirectoryEntries("*.jar").isNotEmpty()) return "$release${File.separator}*"
    val built = file.resolve("../../../$module/target").normalize()
    val libraries = built.resolve("run.classpath")
    if (!libraries.exists()) {
        throw ToolException(
            "the samples are not there. A release has them in the folder samples beside argo.jar (looked for: $release); " +
                "in the sources of ARGO, \"mvn package -Dmaven.test.skip=true\" builds them",
        )
    }
    return built.resolve("classes").toString() + File.pathSeparator + libraries.readText().trim()
}
