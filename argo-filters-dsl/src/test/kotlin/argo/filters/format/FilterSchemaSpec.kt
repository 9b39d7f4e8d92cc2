package argo.filters.format

import argo.filters.filters
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.StringSpec
import io.kotest.property.checkAll
import org.xml.sax.SAXException
import java.io.StringReader
import java.nio.file.Path
import javax.xml.XMLConstants
import javax.xml.transform.stream.StreamSource
import javax.xml.validation.SchemaFactory
import kotlin.io.path.readText

/** Tests the XML schema with which editors complete and check filters. */
class FilterSchemaSpec : StringSpec({
    val schema = SchemaFactory.newInstance(XMLConstants.W3C_XML_SCHEMA_NS_URI)
        .newSchema(XmlFilters::class.java.getResource("filter.xsd"))

    fun validate(text: String) = schema.newValidator().validate(StreamSource(StringReader(text)))

    "it takes each filter that is written" {
        checkAll(500, filters) { validate(XmlFilters.write(it)) }
    }

    "it takes the filters of the page" {
        Regex("```xml\\n(.*?)```", RegexOption.DOT_MATCHES_ALL).findAll(Path.of("../docs/filters.md").readText())
            .forEach { validate(it.groupValues[1]) }
    }

    listOf(
        "<filter/>", "<PerceptionFilter><filter/></PerceptionFilter>", "<PerceptionFilter keep='perhaps'/>",
        "<PerceptionFilter><filter><predicate>a</predicate><parameter id='x'>1</parameter></filter></PerceptionFilter>",
        "<PerceptionFilter><filter><predicate>a</predicate><parameter id='0' operator='GREATER'>1</parameter></filter></PerceptionFilter>",
        "<PerceptionFilter><critical everyMs='3'><predicate>a</predicate></critical></PerceptionFilter>",
    ).forEach { text ->
        "it refuses $text" { shouldThrow<SAXException> { validate(text) } }
    }
})
