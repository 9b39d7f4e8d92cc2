package benchmarks

import javino.LineSettings
import javino.PortException
import javino.Transport
import javino.Transports
import java.net.ServerSocket
import java.nio.file.Files
import java.nio.file.Path
import kotlin.system.measureNanoTime

private const val OPENINGS = 200
private const val EXCHANGES = 5000
private const val CONNECTIONS = 100
private const val PATIENCE_MS = 20_000

/**
 * Compares TLS with TCP: the time to open a connection, the time of a request and an answer of 150 bytes, and the heap per connection.
 * `socat` is the other end, and echoes. Needs `socat` and `openssl`.
 */
internal fun tls() {
    val folder = Files.createTempDirectory("argo-tls")
    System.setProperty("javino.tls", "$folder")
    val certificate = "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=board -keyout own.key"
    run(folder, *"$certificate -out own.crt".split(" ").toTypedArray()).waitFor()
    println(machine())
    for ((scheme, listen) in listOf("tcp" to "TCP-LISTEN:%d", "tls" to "OPENSSL-LISTEN:%d,cert=own.crt,key=own.key,verify=0")) {
        val number = ServerSocket(0).use { it.localPort }
        val echo = run(folder, "socat", listen.format(number) + ",reuseaddr,fork,bind=127.0.0.1", "PIPE")
        try {
            measure("$scheme://127.0.0.1:$number")
        } finally {
            echo.descendants().forEach { it.destroy() }
            echo.destroy()
        }
    }
    folder.toFile().deleteRecursively()
}

private fun run(folder: Path, vararg command: String): Process = ProcessBuilder(*command).directory(folder.toFile())
    .redirectErrorStream(true).redirectOutput(ProcessBuilder.Redirect.DISCARD).start()

private fun open(port: String): Transport = Transports.open(port, LineSettings(100_000_000))

private fun measure(port: String) {
    awaitEcho(port)
    val openings = LongArray(OPENINGS) { measureNanoTime { open(port).use { exchange(it, 1) } } }.copyOfRange(OPENINGS / 2, OPENINGS)
    val exchanges = open(port).use { line -> LongArray(EXCHANGES) { measureNanoTime { exchange(line, 150) } } }
        .copyOfRange(EXCHANGES / 2, EXCHANGES)
    val before = usedHeap()
    val lines = List(CONNECTIONS) { open(port).also { exchange(it, 150) } }
    val heap = (usedHeap() - before) / CONNECTIONS / 1024
    lines.forEach(Transport::close)
    println("$port: opening and one byte there and back ${words(openings)}, 150 bytes ${words(exchanges)}, heap $heap KB")
}

private fun words(nanos: LongArray) = Distribution(nanos).let { figures("median %.2f ms, p99 %.2f ms", it.ms(0.5), it.ms(0.99)) }

private fun awaitEcho(port: String) = check(awaitAtMost(PATIENCE_MS / 1000) { isOpen(port) }) { "nothing answers at $port" }

private fun isOpen(port: String): Boolean = try {
    open(port).close()
    true
} catch (_: PortException) {
    false
}

private fun exchange(line: Transport, count: Int) {
    val bytes = ByteArray(count)
    line.write(bytes, 0, count, PATIENCE_MS)
    var read = 0
    while (read < count) read += line.read(bytes, 0, count - read, PATIENCE_MS).also { check(it > 0) { "nothing came back" } }
}
