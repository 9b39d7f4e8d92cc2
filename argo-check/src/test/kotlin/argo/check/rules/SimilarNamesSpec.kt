package argo.check.rules

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.checkAll

class SimilarNamesSpec : FunSpec({
    val name = Arb.list(Arb.element("a", "b", "A", "1", "_"), 1..14).map { it.joinToString("") }

    test("the name that is meant is that of the smallest distance among all that are near") {
        checkAll(Arb.list(name, 0..40), name) { names, written ->
            val near = names.filter { SimilarNames(listOf(it)).near(written) != null }
            SimilarNames(names).near(written) shouldBe near.minWithOrNull(compareBy({ editDistance(written, it) }, { it }))
        }
    }

    test("each slip of a letter is near, and in long names two slips are") {
        val slips = listOf<(String, Int) -> String>(
            { text, at -> text.removeRange(at, at + 1) },
            { text, at -> text.substring(0, at) + "z" + text.substring(at) },
            { text, at -> text.replaceRange(at, at + 1, "z") },
            { text, at -> text.substring(0, at) + text[at + 1] + text[at] + text.substring(at + 2) },
        )
        checkAll(Arb.element(slips), Arb.int(1..5)) { slip, at ->
            SimilarNames(listOf("distance")).near(slip("distance", at)) shouldBe "distance"
        }
        SimilarNames(listOf("distanceleft")).near("distnaceletf") shouldBe "distanceleft"
        SimilarNames(listOf("distanceleft")).near("ditanceleftt") shouldBe "distanceleft"
    }

    test("another first letter, and one more or less there, make another word, but a swap with the second is a slip") {
        val names = SimilarNames(listOf("inner", "size", "kick", "dist"))
        listOf("winner", "gsize", "pick").map(names::near) shouldBe listOf(null, null, null)
        names.near("idst") shouldBe "dist"
        SimilarNames(listOf(".count")).near("count") shouldBe ".count"
    }

    test("a digit, and a part of one letter, tell things apart that are meant to be two") {
        SimilarNames(listOf("pos1", "OldX")).run { near("pos2") ?: near("OldY") } shouldBe null
    }
})
