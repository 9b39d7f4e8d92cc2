package argo.ros.mapping

import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText

/** The editor schema accepts every line that the reader accepts. */
class MappingSchemaSpec : FunSpec({
    val schema = Json.parseToJsonElement(checkNotNull(MappingSchemaSpec::class.java.getResource("mapping.schema.json")).readText())
    fun pattern(key: String) = Regex(
        schema.jsonObject["properties"]!!.jsonObject[key]!!.jsonObject["items"]!!.jsonObject["pattern"]!!.jsonPrimitive.content,
    )

    fun lines(text: String, key: String) = text.substringAfter("$key:\n", "").lines().map { it.substringBefore(" #") }
        .filterNot { it.isBlank() || it.trim().startsWith("#") }.takeWhile { it.trim().startsWith("- ") }.map { it.trim().drop(2).trim() }

    test("it takes all lines of the mappings that are read") {
        val page = Path.of("../docs/ros.md").readText()
        val blocks = Regex("```yaml\n(.*?)```", RegexOption.DOT_MATCHES_ALL).findAll(page).map { it.groupValues[1] }.toList()
        val nav2 = checkNotNull(Mapping::class.java.getResource("/nav2.ros.yaml")).readText()
        mappingOf(nav2, "nav2").percepts.shouldNotBeEmpty()
        for (key in listOf("percepts", "commands")) {
            (blocks + nav2).flatMap { lines(it, key) }.shouldNotBeEmpty().forAll { pattern(key).matches(it) shouldBe true }
        }
    }
    test("it takes each line that the reader takes, also mistaken ones") {
        fun isRead(key: String, line: String) = runCatching { mappingOf("$key:\n  - $line", "t") }.isSuccess
        val mistakes = checkNotNull(MappingSchemaSpec::class.java.getResource("/mistakes.txt")).readText().lines()
        val lines = mistakes.filter { ": " in it && !it.startsWith("#") }.map { it.substringBefore(" => ").split(": ", limit = 2) }
            .flatMap { (key, rules) -> rules.split(" & ").map { key to it } }
        val files = Path.of("src/test/resources").listDirectoryEntries("*.ros.yaml").map { it.readText() }
        val all = lines + listOf("percepts", "commands").flatMap { key -> files.flatMap { lines(it, key) }.map { key to it } }
        val read = all.filter { (key, line) -> isRead(key, line) }
        read.shouldNotBeEmpty().forAll { (key, line) -> pattern(key).matches(line) shouldBe true }
    }
    test("it refuses lines that are read as mistakes at their beginning") {
        listOf("sonar", "/a Bool", "/a std_msgs/Bool dist", "tf map", "/a std_msgs/Bool iff").forAll {
            pattern("percepts").matches(it) shouldBe false
        }
        listOf("move(v) -> /a a_msgs/A", "stop /a std_msgs/Empty", "Stop -> /a std_msgs/Empty", "a -> /a a_msgs/A wthin 5 s").forAll {
            pattern("commands").matches(it) shouldBe false
        }
    }
})
