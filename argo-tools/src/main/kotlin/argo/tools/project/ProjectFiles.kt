package argo.tools.project

/**
 * The text files of a new project, by their paths in it.
 *
 * @param withTestKit whether the test kit is in its `lib/`
 */
internal fun projectFiles(project: ProjectName, withTestKit: Boolean): Map<String, String> {
    val words = mapOf(
        "NAME" to project.name, "ID" to project.id, "JASON" to JASON_VERSION, "KOTLIN" to KOTLIN_VERSION, "KOTEST" to KOTEST_VERSION,
        "TESTKIT_DEPENDENCY" to if (withTestKit) template("testkit-dependency.xml") else "",
    )
    val sources = mapOf(
        "README.md" to "README.md",
        ".gitignore" to "gitignore",
        "build.gradle" to "build.gradle",
        "settings.gradle" to "settings.gradle",
        "pom.xml" to "pom.xml",
        "logging.properties" to "logging.properties",
        "${project.id}.mas2j" to "mas2j",
        "src/agt/robot.asl" to "robot.asl",
        "src/main/kotlin/RobotFilters.kt" to "RobotFilters.kt",
        "src/test/kotlin/RobotFiltersSpec.kt" to "RobotFiltersSpec.kt",
        "sketch/${project.id}/${project.id}.ino" to "sketch.ino",
        "recordings/drive.rec" to "drive.rec",
    ) + if (withTestKit) mapOf("src/test/kotlin/RobotSpec.kt" to "RobotSpec.kt") else emptyMap()
    val texts = sources.mapValues { (_, source) -> PLACEHOLDER.replace(template(source)) { words.getValue(it.groupValues[1]) } }
    return texts + ("src/main/resources/META-INF/services/argo.filters.FilterProvider" to "RobotFilters\n")
}

/** The versions for a new project, equal to those in gradle/libs.versions.toml. */
internal const val JASON_VERSION = "3.2.1"
internal const val KOTLIN_VERSION = "2.4.10"
internal const val KOTEST_VERSION = "6.2.4"

private val PLACEHOLDER = Regex("@([A-Z_]+)@")

private fun template(name: String): String =
    checkNotNull(ProjectName::class.java.getResource(name)) { "the template $name is not in this jar" }.readText()
