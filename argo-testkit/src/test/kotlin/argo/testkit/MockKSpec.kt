package argo.testkit

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.mockk.every
import io.mockk.mockk
import io.mockk.verify
import javino.link.Javino

class MockKSpec : FunSpec({
    test("a program that uses Javino itself can be tested with a mock of it") {
        val javino = mockk<Javino>()
        every { javino.requestData("ttyACM0", "getPercepts") } returns true
        every { javino.data } returns "light(3);"
        every { javino.sendCommand("ttyACM0", "ledOn") } returns true

        lamp(javino)

        verify(exactly = 1) { javino.sendCommand("ttyACM0", "ledOn") }
    }

    test("so can what it does when the board does not answer") {
        val javino = mockk<Javino>()
        every { javino.requestData(any(), any()) } returns false
        every { javino.lastError() } returns "no answer"

        lamp(javino) shouldBe "no answer"

        verify(exactly = 0) { javino.sendCommand(any(), any()) }
    }
})

private fun lamp(javino: Javino): String? {
    if (!javino.requestData("ttyACM0", "getPercepts")) return javino.lastError()
    if (javino.data == "light(3);") javino.sendCommand("ttyACM0", "ledOn")
    return null
}
