package argo.jason

import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.net.ServerSocket
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories

/** Enabled if there is a `socat` with OpenSSL, an `openssl` that makes certificates, and Python for the board. */
private val withSocat: Enabled = run {
    fun runs(vararg command: String) = runCatching { ProcessBuilder(*command).start().waitFor() == 0 }.getOrDefault(false)
    val works = runs("sh", "-c", "socat -V | grep -q 'define WITH_OPENSSL' && openssl version")
    if (works) withPython else Enabled.disabled("needs socat with OpenSSL, and openssl")
}

/** Connects a real agent to a board behind `socat`, which ends the TLS connection, as the page on ports describes. */
class TlsBoardSpec : FunSpec({
    val folder by lazy { tempdir().toPath() }

    fun certificate(name: String) {
        val made = ProcessBuilder(
            "openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "30",
            "-subj", "/CN=$name", "-keyout", "$name.key", "-out", "$name.crt",
        ).directory(folder.toFile()).redirectErrorStream(true).start()
        val said = made.inputReader().readText()
        check(made.waitFor() == 0) { said }
    }

    fun socat(number: Int, link: Path): AutoCloseable {
        val process = ProcessBuilder(
            "socat", "OPENSSL-LISTEN:$number,reuseaddr,fork,bind=127.0.0.1,cert=robot.crt,key=robot.key,cafile=computer.crt,verify=1",
            "$link,raw,echo=0",
        ).directory(folder.toFile()).redirectErrorStream(true).redirectOutput(folder.resolve("socat.log").toFile()).start()
        return AutoCloseable {
            process.descendants().forEach { it.destroy() }
            process.destroy()
            process.waitFor(20, TimeUnit.SECONDS)
        }
    }

    test("the agent that has the certificate drives the board, and one without it fails to open the port and knows why")
        .config(enabledOrReasonIf = { withSocat }, blockingTest = true) {
            listOf("robot", "computer").forEach(::certificate)
            val tls = folder.resolve("tls").createDirectories()
            val number = ServerSocket(0).use { it.localPort }
            val link = folder.resolve("board")
            System.setProperty("javino.tls", "$tls")
            try {
                PythonBoard(link).use { board ->
                    socat(number, link).use {
                        LocalMas().use { mas ->
                            mas.agent("bob", """
                                !start(30).
                                +!start(N) <- argo.port("tls://127.0.0.1:$number", [protocol(2)]); argo.percepts(open);
                                             argo.act(speed(7)); +acted.
                                -!start(0)[error(E),error_msg(M)] <- +failed(E,M).
                                -!start(N)[error(no_such_port)] <- .wait(100); !start(N-1). // socat is starting
                                -!start(N)[error(E),error_msg(M)] <- +failed(E); .print(M).
                            """)
                            mas.awaitBelief("bob", "failed(port_failed)")
                            mas.log shouldContain "the board asks for a certificate of this computer"
                            for (file in listOf("computer.crt", "computer.key")) folder.resolve(file).copyTo(tls.resolve(file))
                            mas.achieve("bob", "start(30)")
                            mas.awaitBelief("bob", "acted")
                            mas.awaitBelief("bob", "dist(f,100)")
                            board.carriedOut.filter { it != "lost" } shouldBe listOf("speed(7)")
                            mas.log shouldContain "this is the first connection to the board, so its certificate, SHA-256 "
                        }
                    }
                }
            } finally {
                System.clearProperty("javino.tls")
            }
        }
})
