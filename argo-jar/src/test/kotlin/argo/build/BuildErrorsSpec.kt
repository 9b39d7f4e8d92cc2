package argo.build

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlin.io.path.writeText

/** Tests which lines of a failed build's log `./argo` prints. */
class BuildErrorsSpec : FunSpec({
    fun errors(log: String): String {
        val file = tempdir().toPath().resolve("build.log").apply { writeText(log.trimIndent()) }
        val bash = ProcessBuilder("bash", "-c", ". ../build-tools/common.bash; errors '$file'").redirectErrorStream(true).start()
        return bash.inputStream.readBytes().decodeToString().also { bash.waitFor() shouldBe 0 }
    }

    test("the line with the reason stays, Maven's advice on itself goes") {
        errors(
            """
            [INFO] BUILD FAILURE
            [ERROR] Failed to execute goal on project samples: Could not resolve dependencies for project argo:samples:jar:0.1.0 -> [Help 1]
            [ERROR] 
            [ERROR] To see the full stack trace of the errors, re-run Maven with the -e switch.
            [ERROR] Re-run Maven using the -X switch to enable full debug logging.
            [ERROR] For more information about the errors and possible solutions, please read the following articles:
            [ERROR] [Help 1] http://cwiki.apache.org/confluence/display/MAVEN/DependencyResolutionException
            [ERROR] After correcting the problems, you can resume the build with the command
            [ERROR]   mvn <args> -rf :samples
            """,
        ) shouldBe "[ERROR] Failed to execute goal on project samples: Could not resolve dependencies for project argo:samples:jar:0.1.0\n"
    }

    test("each of a compiler's errors is there once") {
        errors(
            """
            [ERROR] Arch.kt:3:5 Unresolved reference 'x'.
            [ERROR] Failed to execute goal kotlin:compile on project argo-arch: Compilation failure
            [ERROR] Arch.kt:3:5 Unresolved reference 'x'.
            [ERROR] -> [Help 1]
            """,
        ) shouldBe "[ERROR] Arch.kt:3:5 Unresolved reference 'x'.\n" +
            "[ERROR] Failed to execute goal kotlin:compile on project argo-arch: Compilation failure\n"
    }

    listOf(
        "Plugin maven-resources-plugin:3.3.1 or one of its dependencies could not be resolved: Could not transfer artifact p:pom:3.3.1 " +
            "from/to central: Connect to 127.0.0.1:9 failed: Connection refused -> [Help 1]",
        "Failed to read artifact descriptor for a:b:jar:1: Could not transfer artifact a:b:pom:1 from/to central: Unknown host -> [Help 1]",
    ).forEach { reason ->
        test("where nothing can be fetched it says so and where a proxy is set: $reason") {
            val told = errors("[ERROR] $reason")
            told shouldContain reason.removeSuffix(" -> [Help 1]")
            told shouldContain "Maven Central cannot be reached"
            told shouldContain "~/.m2/settings.xml"
        }
    }

    test("a log without errors gives nothing") {
        errors("[INFO] BUILD SUCCESS") shouldBe ""
    }

    test("a build that failed for another reason says nothing of the network") {
        errors("[ERROR] There are test failures.") shouldNotContain "Maven Central"
    }
})
