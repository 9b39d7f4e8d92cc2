package samples.collision

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeSorted
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import org.w3c.dom.Element
import javax.xml.parsers.DocumentBuilderFactory

class TrackPictureSpec : FunSpec({
    fun picture(distance: Double?, limit: Int = 40) = TrackPicture(distance, limit, 200.0, "driving").drawn(null)

    fun elements(svg: String, tag: String): List<Element> {
        val found = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(svg.byteInputStream()).getElementsByTagName(tag)
        return (0 until found.length).map { found.item(it) as Element }
    }

    fun place(element: Element, name: String) = element.getAttribute(name).removeSuffix("%").toDouble()

    fun front(svg: String) = elements(svg, "svg")[1].let { place(it, "x") + place(it, "width") }

    test("the robot's front is drawn to scale: at the limit's line when it is at the limit, at the wall when it touches it") {
        val svg = picture(40.0).svg
        front(svg) shouldBe place(elements(svg, "line").single(), "x1")
        front(picture(0.0).svg) shouldBe place(elements(svg, "rect").single { it.getAttribute("class") == "wall" }, "x")
        listOf(200.0, 150.0, 40.0, 1.0).map { front(picture(it).svg) }.shouldBeSorted()
    }

    test("what is farther away than the picture is wide stands at its edge") {
        front(picture(1000.0).svg) shouldBe front(picture(200.0).svg)
    }

    test("a robot whose distance is not known is not drawn") {
        with(picture(null)) {
            svg shouldNotContain "class=\"robot\""
            words shouldBe "no distance yet – driving"
        }
    }

    test("the caption is the distance and what the robot does, until there is a conclusion") {
        picture(73.24).words shouldBe "73.2 cm – driving"
        TrackPicture(73.24, 40, 200.0, "stopped").drawn("stopped 73.2 cm from the wall").words shouldBe "stopped 73.2 cm from the wall"
        picture(73.24).svg shouldContain "to stop at 40 cm"
    }

    test("a terminal shows the robot between the start and the wall, and the limit") {
        fun line(distance: Double?) = TrackPicture(distance, 40, 200.0, "driving").line()
        line(200.0) shouldBe "o=o>" + "_".repeat(25) + ":______|"
        line(0.0) shouldBe "_".repeat(29) + ":__o=o>|"
        line(1000.0) shouldBe line(200.0)
        line(null) shouldBe "_".repeat(29) + ":______|"
        line(40.0).indexOf('>') shouldBe line(null).indexOf(':')
        listOf(200.0, 150.0, 90.0, 40.0, 1.0).map { line(it).indexOf('>') }.shouldBeSorted()
    }
})
