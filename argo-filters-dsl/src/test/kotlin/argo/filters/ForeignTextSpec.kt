package argo.filters

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class ForeignTextSpec : FunSpec({
    test("control characters become text that a terminal does not obey") {
        foreignText("a\u001b[31m\nb") shouldBe "a\\x1B[31m\\x0Ab"
    }

    test("a long text keeps its start, and its end if wanted, and says what it omits") {
        foreignText("x".repeat(2_000)) shouldBe "x".repeat(200) + "… 1800 characters …"
        foreignText("a".repeat(500) + "b".repeat(500), first = 2, last = 3) shouldBe "aa… 995 characters …bbb"
    }

    test("a text that is a little longer stays whole") {
        foreignText("x".repeat(279)) shouldBe "x".repeat(279)
    }
})
