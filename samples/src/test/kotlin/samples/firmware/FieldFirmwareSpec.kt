package samples.firmware

import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.core.test.EnabledOrReasonIf
import io.kotest.matchers.shouldBe
import javino.Link
import javino.LinkSettings
import javino.Protocol
import javino.Transports

private const val LIMIT_MS = 20_000
private const val BURSTS = 6
private const val LAMPS = 8

/**
 * A link, as it is by default, and firmware that receives as the version 1 library in the field does: see the sketch `Field`. Both go by
 * the board's time, so that a busy machine does not move frames together.
 */
class FieldFirmwareSpec : FunSpec({
    val built: EnabledOrReasonIf = {
        if (SimulatedUno.isBuilt()) Enabled.enabled else Enabled.disabled("the firmware is not built: ./argo firmware says what it needs")
    }

    for (buildMs in listOf(0, 11)) for (loopMs in listOf(0, 2, 3, 5, 10)) {
        test("a board of the field acts on every command and never restarts: loop() of $loopMs ms, answers built in $buildMs ms").config(
            enabledOrReasonIf = built,
        ) {
            SimulatedUno("Field").use { uno ->
                val settings = LinkSettings.defaults().withProtocol(Protocol.V1)
                Link.over(Transports.open(uno.port, settings.line()), settings, uno.clock).use { link ->
                    link.request("getPercepts", LIMIT_MS).text()
                    link.sendAndAwait("build$buildMs", LIMIT_MS)
                    link.sendAndAwait("loop$loopMs", LIMIT_MS)
                    repeat(BURSTS) {
                        repeat(LAMPS) { lamp -> link.sendAndAwait("lamp($lamp,on)", LIMIT_MS) }
                        link.request("getPercepts", LIMIT_MS).text()
                    }
                    link.request("getPercepts", LIMIT_MS).text() shouldBe "done(${BURSTS * LAMPS});starts(1);"
                }
            }
        }
    }
})
