package argo.ros

import argo.jason.LocalMas
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.assertions.withClue
import io.kotest.matchers.shouldBe

internal class Mas(program: String, vararg options: Pair<String, String>) : LocalMas() {
    init {
        agent("bob", program, options.toMap())
    }

    fun beliefs(): Set<String> = beliefs("bob")

    suspend fun awaitBelief(belief: String) = awaitBelief("bob", belief)

    suspend fun awaitNoBelief(belief: String) = eventually(LIMIT) { withClue({ beliefs() }) { (belief in beliefs()) shouldBe false } }
}
