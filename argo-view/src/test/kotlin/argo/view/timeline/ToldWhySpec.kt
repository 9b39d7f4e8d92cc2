package argo.view.timeline

import argo.tools.why.Told
import argo.view.HttpResponse
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.IOException
import java.util.concurrent.CompletableFuture
import java.util.concurrent.CountDownLatch

class ToldWhySpec : FunSpec({
    val asked = mapOf("agent" to "bob", "command" to "17")

    fun HttpResponse.said() = body.decodeToString()

    test("a question that comes while another one is answered is refused, and the next one is not").config(blockingTest = true) {
        val begun = CountDownLatch(1)
        val end = CountDownLatch(1)
        val why = ToldWhy {
            begun.countDown()
            end.await()
            Told(listOf("1.000 s  agent bob sent stop", "  because"), "")
        }
        val first = CompletableFuture.supplyAsync { why.respond(asked) }
        begun.await()
        why.respond(asked).run {
            status shouldBe 409
            said() shouldContain "another question is being answered"
        }
        end.countDown()
        first.get().said() shouldBe """{"lines":["1.000 s  agent bob sent stop","  because"]}"""
        why.respond(asked).status shouldBe 200
    }

    test("what cannot be answered is said in words") {
        ToldWhy { null }.respond(asked).said() shouldContain "agent bob is not recorded any more"
        ToldWhy { Told(emptyList(), "there is no command #17") }.respond(asked).said() shouldContain "there is no command #17"
        ToldWhy { throw IOException("no java") }.respond(asked).said() shouldContain "the tool why cannot be run: no java"
        ToldWhy { null }.respond(mapOf("agent" to "bob", "command" to "x")).status shouldBe 400
    }
})
