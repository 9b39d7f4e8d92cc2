package argo.view

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.io.IOException

class BroadcastSpec : FunSpec({
    test("a page counts as open until the end of its response is written") {
        val states = Broadcast()
        val written = ArrayList<String?>()
        states.serve(begin = { states.publish("last", isLast = true) }, send = written::add) {
            written += "end"
            states.isWatched shouldBe true
        }
        written.shouldContainExactly("last", "end")
        states.isWatched shouldBe false
    }

    test("a page whose connection breaks is open no longer, and no end is written to it") {
        val states = Broadcast()
        shouldThrow<IOException> {
            states.serve(begin = { states.publish("first", isLast = false) }, send = { throw IOException("gone") }) { error("written") }
        }
        states.isWatched shouldBe false
    }

    test("a page is sent what is published while it is open, and the newest only where it is slow") {
        val states = Broadcast()
        states.publish("before", isLast = false)
        val written = ArrayList<String?>()
        states.serve(
            begin = { states.publish("1", isLast = false) },
            send = {
                written += it
                if (it == "1") listOf("2", "3").forEach { next -> states.publish(next, isLast = next == "3") }
            },
            end = {},
        )
        written.shouldContainExactly("1", "3")
    }
})
