package argo.filters.format

import argo.filters.Condition
import argo.filters.FilterException
import argo.filters.GroundTerm
import argo.filters.Operator
import argo.filters.PerceptionFilter
import argo.filters.Rule
import argo.filters.TermTest
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FreeSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.ByteArrayOutputStream
import java.io.PrintStream
import java.nio.charset.Charset

private val expected = PerceptionFilter("f", Rule("d", Condition.Argument(0, TermTest.Compare(Operator.EQ, GroundTerm.Text("é漢")))))

private fun document(declaration: String, text: String = "é漢", lineEnd: String = "\n") =
    "$declaration<PerceptionFilter>$lineEnd<filter><predicate>${lineEnd}d$lineEnd</predicate>" +
        "<parameter id=\"0\">\"$text\"</parameter></filter></PerceptionFilter>"

private fun read(bytes: ByteArray) = XmlFilters.read(bytes.inputStream(), "f.xml")

class XmlEncodingSpec : FreeSpec({
    "UTF-8 is read without a declaration" { read(document("").toByteArray()) shouldBe expected }

    "every line end is read" {
        for (lineEnd in listOf("\n", "\r\n", "\r")) {
            read(document("<?xml version='1.0'?>", lineEnd = lineEnd).toByteArray()) shouldBe expected
        }
    }

    "a byte-order mark is no part of the text" - {
        for (charset in listOf("UTF-8", "UTF-16LE", "UTF-16BE")) {
            charset { read(("\uFEFF" + document("<?xml version='1.0'?>")).toByteArray(Charset.forName(charset))) shouldBe expected }
        }
        "nor in text that is already decoded" { XmlFilters.read("\uFEFF" + document(""), "f.xml") shouldBe expected }
    }

    "the declaration's encoding is used" - {
        for (charset in listOf("UTF-8", "GB18030", "UTF-16LE", "UTF-16BE")) {
            charset {
                read(document("<?xml version=\"1.0\" encoding='$charset'?>").toByteArray(Charset.forName(charset))) shouldBe expected
            }
        }
        "Latin-1" {
            read(document("<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>", "é").toByteArray(Charsets.ISO_8859_1)) shouldBe
                PerceptionFilter("f", Rule("d", Condition.Argument(0, TermTest.Compare(Operator.EQ, GroundTerm.Text("é")))))
        }
    }

    "text that is already decoded may declare any encoding" {
        XmlFilters.read(document("<?xml version='1.0' encoding='ISO-8859-1'?>"), "f.xml") shouldBe expected
    }

    "an unknown encoding is refused" {
        for (name in listOf("KLINGON-8", "", "no such/thing")) {
            shouldThrow<FilterException> { read(document("<?xml version='1.0' encoding='$name'?>").toByteArray()) }.message shouldContain
                "Invalid encoding name \"$name\""
        }
    }

    "bytes that are not in the encoding are refused where they stand" {
        val bytes = document("<?xml version='1.0'?>\n", "é").toByteArray(Charsets.ISO_8859_1)
        shouldThrow<FilterException> { read(bytes) }.message shouldContain "f.xml:5:32: a byte that is not UTF-8"
    }

    "bytes that are no text are refused, and nothing is printed" {
        val printed = ByteArrayOutputStream()
        val standard = System.err
        System.setErr(PrintStream(printed))
        try {
            shouldThrow<FilterException> { read(byteArrayOf(0xC3.toByte(), '('.code.toByte(), '>'.code.toByte(), 0)) }
        } finally {
            System.setErr(standard)
        }
        "$printed" shouldBe ""
    }

    "text cut in the middle of a character is refused" {
        val bytes = document("").toByteArray()
        val cut = bytes.copyOf(bytes.indexOfFirst { it < 0 } + 1)
        shouldThrow<FilterException> { read(cut) }
    }
})
