package argo.tools.board

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private fun observed(vararg percepts: String) = ObservedKinds().apply { percepts.forEach(::add) }

private fun kinds(vararg percepts: String) = observed(*percepts).kinds().map { "$it" }

class ObservedKindsSpec : FunSpec({
    test("numbers have the range that was observed, atoms are choices, and percepts of other numbers of arguments are other kinds") {
        kinds("dist(f,30)", "dist(b,-2.50)", "dist(7)", "ready", "dist(f,31)") shouldBe
            listOf("dist(f|b, -2.50..31)", "dist(7..7)", "ready")
    }

    test("an argument that is a number and an atom, a text, a list, or one of many atoms may be anything") {
        kinds("a(1)", "a(x)", "b(\"x\")", "c([1,2])", "d(1e5)") shouldBe listOf("a(_)", "b(_)", "c(_)", "d(_)")
        kinds(*Array(13) { "word(w$it)" }) shouldBe listOf("word(_)")
    }

    test("kinds beyond the limit, and functors in quotes, are counted") {
        val many = observed(*Array(203) { "p$it" }, "'P'(1)")
        many.kinds().size shouldBe 200
        many.others shouldBe 4
    }
})
