package argo.ros

import argo.ros.mapping.UsualType
import argo.ros.mapping.mappingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forAll
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.string.shouldContain
import java.nio.file.Path
import kotlin.io.path.readText

class RosDocumentSpec : FunSpec({
    val page = Path.of("../docs/ros.md").readText()

    test("the mappings on the page are read") {
        val blocks = Regex("```yaml\n(.*?)```", RegexOption.DOT_MATCHES_ALL).findAll(page).map { it.groupValues[1] }.toList()
        blocks.shouldNotBeEmpty().forEach { mappingOf(it, "docs/ros.md") }
    }
    test("the page names every type that has a short form") {
        UsualType.names.forAll { name ->
            val isShort = name.startsWith("std_msgs/") && name != "std_msgs/Bool" || "Stamped" in name // a list omits the package
            page shouldContain "`${if (isShort) name.substringAfter('/') else name}`"
        }
    }
})
