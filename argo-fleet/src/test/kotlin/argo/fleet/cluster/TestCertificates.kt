package argo.fleet.cluster

import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories

/** Makes certificates of the computers [names] in [folder], with the program openssl: `NAME.crt` and `NAME.key`. */
internal class TestCertificates(private val folder: Path, vararg names: String) {
    init {
        names.forEach(::make)
    }

    private fun make(name: String) {
        val command = "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=$name" +
            " -keyout $name.key -out $name.crt"
        val openssl = ProcessBuilder(command.split(" ")).directory(folder.toFile()).redirectErrorStream(true).start()
        check(openssl.waitFor(60, TimeUnit.SECONDS) && openssl.exitValue() == 0) { String(openssl.inputStream.readAllBytes()) }
    }

    /** Makes the `tls://` folder of the computer [name], which trusts the computers [known]. */
    fun of(name: String, vararg known: String): Path {
        val own = folder.resolve("of-$name").createDirectories()
        folder.resolve("$name.crt").copyTo(own.resolve("computer.crt"))
        folder.resolve("$name.key").copyTo(own.resolve("computer.key"))
        own.resolve("fleet").createDirectories()
        known.forEach { folder.resolve("$it.crt").copyTo(own.resolve("fleet/$it.crt")) }
        return own
    }
}
