package argo.recording.recorder

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import jason.asSyntax.ASSyntax
import jason.asSyntax.ListTerm
import jason.asSyntax.Term

class CallNoteSpec : FunSpec({
    val list = "[1,2]"

    fun args(): Array<Term> = arrayOf(ASSyntax.parseTerm(list))

    test("a call is recorded with what was found in its cycle, and not with what a loop finds later") {
        val note = CallNote(".date", args(), isOfProject = false)
        note.isBacktracking = true
        note.answered(mapOf(0 to "1"))
        note.end()
        note.answered(mapOf(0 to "2"))
        note.call().answers shouldBe listOf(mapOf(0 to "1"))
    }

    test("what an action of the project does with its arguments changes nothing of its call") {
        val args = args()
        val note = CallNote("my.action", args, isOfProject = true)
        (args.single() as ListTerm).clear()
        note.call().run { args.toList().map { "$it" } to this.args } shouldBe (listOf("[]") to listOf(list))
    }
})
