package argo.tools.project

/**
 * Returns the text files of a new project, by their paths in the project.
 *
 * @param withTestKit true if the project's `lib/` contains the test kit
 * @param boards the number of boards that the agent perceives, 1 or 2
 */
internal fun projectFiles(project: ProjectName, withTestKit: Boolean, boards: Int = 1): Map<String, String> {
    val words = mapOf(
        "NAME" to project.name, "ID" to project.id, "JASON" to JASON_VERSION, "KOTLIN" to KOTLIN_VERSION, "KOTEST" to KOTEST_VERSION,
        "TESTKIT_DEPENDENCY" to if (withTestKit) template("testkit-dependency.xml") else "",
    ) + if (boards == 1) wordsOfOne(project) else wordsOfTwo(project)
    val sources = COMMON + mapOf("${project.id}.mas2j" to "mas2j") + (if (boards == 1) sourcesOfOne(project) else sourcesOfTwo(project))
    val texts = sources.filterKeys { withTestKit || it != AGENT_TEST }
        .mapValues { (_, source) -> PLACEHOLDER.replace(template(source)) { words.getValue(it.groupValues[1]) } }
    return texts + ("src/main/resources/META-INF/services/argo.filters.FilterProvider" to "RobotFilters\n")
}

private const val AGENT = "src/agt/robot.asl"
private const val AGENT_TEST = "src/test/kotlin/RobotSpec.kt"

private val COMMON = mapOf(
    "README.md" to "README.md",
    ".gitignore" to "gitignore",
    "build.gradle" to "build.gradle",
    "settings.gradle" to "settings.gradle",
    "pom.xml" to "pom.xml",
    "logging.properties" to "logging.properties",
    "src/main/kotlin/RobotFilters.kt" to "RobotFilters.kt",
    "src/test/kotlin/RobotFiltersSpec.kt" to "RobotFiltersSpec.kt",
    "recordings/drive.rec" to "drive.rec",
)

private fun sourcesOfOne(project: ProjectName) =
    mapOf(AGENT to "robot.asl", AGENT_TEST to "RobotSpec.kt", "sketch/${project.id}/${project.id}.ino" to "sketch.ino")

private fun sourcesOfTwo(project: ProjectName) = mapOf(
    AGENT to "two/robot.asl",
    AGENT_TEST to "two/RobotSpec.kt",
    "sketch/${project.id}_eyes/${project.id}_eyes.ino" to "two/eyes.ino",
    "sketch/${project.id}_lamp/${project.id}_lamp.ino" to "two/lamp.ino",
    "recordings/lamp.rec" to "two/lamp.rec",
)

private fun wordsOfOne(project: ProjectName) = mapOf(
    "SUBJECT" to "A Jason agent that turns the LED of its board on while something is near in front of it.",
    "UPLOAD" to "open `sketch/${project.id}/${project.id}.ino` and upload it",
    "WRITE" to "Write the port into `$AGENT`: `board(ttyACM0).`",
)

private fun wordsOfTwo(project: ProjectName) = mapOf(
    "SUBJECT" to "A Jason agent of two boards, that turns the LED of one on while something is near in front of the other.",
    "UPLOAD" to "and upload `sketch/${project.id}_eyes/${project.id}_eyes.ino` to one board and " +
        "`sketch/${project.id}_lamp/${project.id}_lamp.ino` to the other",
    "WRITE" to "Write the ports into `$AGENT`: `boards([port(ttyACM0,[as(eyes)]), port(ttyACM1,[as(lamp)])]).`",
)

/** The versions of libraries in a new project. These versions must equal those in ARGO's pom.xml. */
internal const val JASON_VERSION = "3.2.1"
internal const val KOTLIN_VERSION = "2.4.10"
internal const val KOTEST_VERSION = "6.2.4"

private val PLACEHOLDER = Regex("@([A-Z_]+)@")

private fun template(name: String): String =
    checkNotNull(ProjectName::class.java.getResource(name)) { "the template $name is not in this jar" }.readText()
