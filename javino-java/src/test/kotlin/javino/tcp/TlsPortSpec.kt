package javino.tcp

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.core.test.Enabled
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import javino.Line
import javino.LineSettings
import javino.PortException
import javino.PortFaultException
import javino.PortGoneException
import javino.Transport
import javino.TransportContract
import javino.Transports
import javino.readFully
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.time.Duration.Companion.seconds

/** Long, because the board runs in this process and may be slow. */
private const val LONG_MILLIS = 60_000

private fun open(board: TlsBoard, folder: Path): Transport =
    TlsConnector.connect(board.port, TcpAddress("127.0.0.1", board.number), TlsFolder(folder), LineSettings.defaults(), LONG_MILLIS)

private fun line(breaks: Boolean): Line {
    val board = TlsBoard(TestCertificate.BOARD)
    val far = board.accept(breaks)
    val computer = open(board, Files.createTempDirectory("argo-tls"))
    val end = far.end()
    return Line(computer, end, end::close, board::close)
}

/** A connection that the far end closes. */
internal class TlsTransportSpec : TransportContract(Enabled.enabled, { line(breaks = false) })

/** A connection that breaks. */
internal class BrokenTlsTransportSpec : TransportContract(Enabled.enabled, { line(breaks = true) })

class TlsPortSpec : FunSpec({
    timeout = 60.seconds.inWholeMilliseconds
    blockingTest = true

    val folder by lazy { tempdir().toPath().resolve("tls") } // does not exist yet
    fun fileOf(board: TlsBoard) = folder.resolve("127.0.0.1_${board.number}.crt")

    beforeTest { folder.toFile().deleteRecursively() } // a board may get the port number of an earlier one

    fun talks(board: TlsBoard) {
        val far = board.accept()
        open(board, folder).use { computer ->
            far.end().use { end ->
                computer.write("ask".toByteArray(), 0, 3, 20_000)
                end.readFully(3).decodeToString() shouldBe "ask"
                end.write("answer".toByteArray(), 0, 6, 20_000)
                computer.readFully(6).decodeToString() shouldBe "answer"
            }
        }
    }

    fun refusal(board: TlsBoard): String {
        board.accept()
        return shouldThrow<PortFaultException> { open(board, folder) }.message.orEmpty()
    }

    test("the certificate of the first connection is kept, and another one is refused with both, the file, and what to do") {
        val file = TlsBoard(TestCertificate.BOARD).use { board ->
            repeat(2) { talks(board) }
            fileOf(board)
        }
        file.readText() shouldContain "BEGIN CERTIFICATE"
        val other = TestCertificate("other")
        TlsBoard(other).use { board ->
            file.toFile().copyTo(fileOf(board).toFile())
            val message = refusal(board)
            for (part in listOf(TlsFolder.fingerprint(other.certificate), TlsFolder.fingerprint(TestCertificate.BOARD.certificate))) {
                message shouldContain part
            }
            message shouldContain "shows another certificate"
            message shouldContain "${fileOf(board)}"
            message shouldContain "delete that file"
            fileOf(board).deleteExisting()
            talks(board)
        }
    }

    test("a certificate that is given is the board's from the first connection on, and one that is refused is not kept") {
        TlsBoard(TestCertificate.BOARD).use { board ->
            folder.createDirectories()
            TestCertificate.BOARD.write(fileOf(board))
            talks(board)
            TestCertificate("other").write(fileOf(board))
            val given = fileOf(board).readText()
            refusal(board) shouldContain "shows another certificate"
            fileOf(board).readText() shouldBe given
        }
    }

    test("a certificate that has expired, or is not valid yet, is refused with the dates and what to do") {
        TlsBoard(TestCertificate("old", startDays = -10, days = 5)).use { board ->
            refusal(board) shouldContain
                Regex("""expired on \d{4}-\d\d-\d\d, and this computer's clock says .* Put a new one on the board""")
            fileOf(board).exists() shouldBe false
        }
        TlsBoard(TestCertificate("young", startDays = 5, days = 5)).use { refusal(it) shouldContain "Set the clock that is wrong" }
    }

    /** Returns why the board refuses the computer. The board may refuse only after the connection is made. */
    fun refusalByBoard(board: TlsBoard): String {
        board.accept()
        return shouldThrow<PortException> { open(board, folder).use { it.read(ByteArray(1), 0, 1, LONG_MILLIS) } }.message.orEmpty()
    }

    test("a board that asks for the computer's certificate gets it, and without it, or with another, the error says so") {
        for (algorithm in listOf("EC", "RSA")) {
            val computer = TestCertificate("computer", algorithm = algorithm)
            TlsBoard(TestCertificate.BOARD, computer).use { board ->
                folder.createDirectories()
                refusalByBoard(board) shouldContain "asks for a certificate of this computer"
                TestCertificate("nobody").write(folder.resolve("computer.crt"), folder.resolve("computer.key"))
                refusalByBoard(board) shouldContain "does not accept this computer's certificate, $folder/computer.crt"
                computer.write(folder.resolve("computer.crt"), folder.resolve("computer.key"))
                talks(board)
                folder.toFile().deleteRecursively()
            }
        }
    }

    test("files that are none are named, with what they should hold, before the board is connected to") {
        TlsBoard(TestCertificate.BOARD).use { board ->
            fun message() = shouldThrow<PortException> { open(board, folder) }.message.orEmpty()
            folder.createDirectories()
            fileOf(board).writeText("nonsense")
            message() shouldContain "${fileOf(board)} holds no certificate; one begins with -----BEGIN CERTIFICATE-----"
            fileOf(board).deleteExisting()
            TestCertificate.BOARD.write(folder.resolve("computer.crt"))
            message() shouldContain "computer.key is missing"
            folder.resolve("computer.key").writeText("-----BEGIN RSA PRIVATE KEY-----\nAA==\n-----END RSA PRIVATE KEY-----\n")
            message() shouldContain "openssl pkcs8 -topk8"
            folder.resolve("computer.key").writeText("-----BEGIN PRIVATE KEY-----\nAA==\n-----END PRIVATE KEY-----\n")
            message() shouldContain "no key for the certificate"
            folder.toFile().deleteRecursively()
        }
    }

    test("a far end without TLS is asked about, whether it answers in another way or not at all") {
        Loopback().use { server ->
            val address = TcpAddress("127.0.0.1", server.number)
            fun message(limitMillis: Int) = shouldThrow<PortFaultException> {
                TlsConnector.connect(server.port, address, TlsFolder(folder), LineSettings.defaults(), limitMillis)
            }.message.orEmpty()
            thread(isDaemon = true) { server.accept().use { it.getOutputStream().write("fffe05hello".toByteArray()) } }
            message(LONG_MILLIS) shouldContain "tcp://127.0.0.1:${server.number}, without TLS, meant?"
            val silent = thread(isDaemon = true) { server.accept() }
            message(100) shouldContain "did not begin TLS within 100 ms"
            silent.join()
        }
    }

    test("records that arrive byte by byte, slower than a read waits, are read whole") {
        TlsBoard(TestCertificate.BOARD).use { board ->
            var slow: DrippingSocket? = null
            val far = board.accept { plain -> DrippingSocket(plain, 15).also { slow = it } }
            open(board, folder).use { computer ->
                val end = far.end()
                slow!!.drips = true
                val writer = thread(isDaemon = true) { repeat(3) { end.write("answer$it".toByteArray(), 0, 7, 20_000) } }
                val bytes = ByteArray(21)
                var read = 0
                while (read < 21) read += computer.read(bytes, read, 21 - read, 5)
                bytes.decodeToString() shouldBe "answer0answer1answer2"
                writer.join(TimeUnit.SECONDS.toMillis(20))
                slow.drips = false
                end.close()
            }
        }
    }

    test("what was written right before a connection is closed arrives") {
        TlsBoard(TestCertificate.BOARD).use { board ->
            val far = board.accept()
            val computer = open(board, folder)
            val end = far.end()
            end.write(ByteArray(1000), 0, 1000, 20_000)
            computer.readFully(1)
            computer.write("stop".toByteArray(), 0, 4, 20_000)
            computer.close()
            end.readFully(4).decodeToString() shouldBe "stop"
            shouldThrow<PortGoneException> { end.read(ByteArray(1), 0, 1, 20_000) }
            end.close()
        }
    }

    test("names are those of tcp, and all spellings of one place are one port") {
        Transports.canonicalName("TLS://Robot:04433/") shouldBe "tls://robot:4433"
        shouldThrow<PortException> { Transports.open("tls://robot", LineSettings.defaults()) }.message shouldContain "tls://HOST:PORT"
        TlsFolder(Path.of("f")).fileOf(TcpAddress("FE80::1%eth0", 1)) shouldBe Path.of("f", "_fe80__1_eth0__1.crt")
    }
})
