package argo.ros.bridge

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class SilentTopicsSpec : FunSpec({
    val limit = SilentTopics.LIMIT_NANOS

    test("a topic that says nothing is named each time that the limit is over, since it may come with another type") {
        val topics = SilentTopics()
        topics.keepOnly(listOf("/a", "/b"), 0)
        topics.next(limit) shouldBe emptyList()
        topics.heard("/b", limit)
        topics.next(limit + 1) shouldBe listOf("/a")
        topics.next(limit + 2) shouldBe emptyList()
        topics.heard("/b", limit + 3)
        topics.next(2 * limit + 2) shouldBe listOf("/a")
        topics.next(2 * limit + 4) shouldBe listOf("/b")
    }

    test("a topic is not silent while it is not subscribed to") {
        val topics = SilentTopics()
        topics.keepOnly(listOf("/a", "/b"), 0)
        topics.keepOnly(listOf("/b"), limit)
        topics.keepOnly(listOf("/a", "/b"), limit + 1)
        topics.next(limit + 1) shouldBe listOf("/b")
        topics.next(2 * limit + 1) shouldBe emptyList()
        topics.next(2 * limit + 2).sorted() shouldBe listOf("/a", "/b")
    }
})
