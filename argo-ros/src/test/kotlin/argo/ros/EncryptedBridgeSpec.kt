package argo.ros

import argo.links.Wish
import argo.ros.mapping.mappingOf
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import javino.LineClock
import javino.link.SendOptions
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import java.io.File
import java.net.URI
import java.nio.file.Path
import java.security.KeyStore
import java.util.concurrent.TimeUnit
import javax.net.ssl.KeyManagerFactory
import javax.net.ssl.SSLContext
import javax.net.ssl.TrustManagerFactory

private val PASSWORD = "secret".toCharArray()
private const val LIMIT_MS = 20_000

/** Makes a TLS context with a self-signed certificate that it trusts. Puts the key into [folder]. */
private fun contextOfLocalhost(folder: File): SSLContext {
    val file = folder.resolve("store.p12")
    val keytool = Path.of(System.getProperty("java.home"), "bin", "keytool")
    val certificate = listOf("-genkeypair", "-alias", "own", "-keyalg", "EC", "-dname", "CN=localhost", "-ext", "san=dns:localhost")
    val store = listOf("-storetype", "PKCS12", "-keystore", "$file", "-storepass", String(PASSWORD))
    ProcessBuilder(listOf("$keytool") + certificate + store).inheritIO().start().waitFor() shouldBe 0
    val keys = KeyStore.getInstance(file, PASSWORD)
    val own = KeyManagerFactory.getInstance(KeyManagerFactory.getDefaultAlgorithm()).apply { init(keys, PASSWORD) }
    val certificates = KeyStore.getInstance("PKCS12").apply {
        load(null, null)
        setCertificateEntry("own", keys.getCertificate("own"))
    }
    val trusted = TrustManagerFactory.getInstance(TrustManagerFactory.getDefaultAlgorithm()).apply { init(certificates) }
    return SSLContext.getInstance("TLS").apply { init(own.keyManagers, trusted.trustManagers, null) }
}

@Tags("Thorough")
class EncryptedBridgeSpec : FunSpec({
    val mapping = mappingOf(
        """
        percepts:
          - /count std_msgs/Int32
        commands:
          - reset -> service /reset std_srvs/Trigger
        """.trimIndent(),
        "robot.ros.yaml",
    )

    test("long messages and answers pass an encrypted connection in both directions, and a second connection does not wait") {
        val before = SSLContext.getDefault()
        val context = contextOfLocalhost(tempdir()).also(SSLContext::setDefault)
        try {
            TestBridge(tls = context).use { bridge ->
                bridge.serve("/reset") { true to JsonObject(mapOf("success" to JsonPrimitive(true))) }
                fun open() = RosLink.open("robot", URI("wss://localhost:${bridge.number}/"), mapping, true, LineClock.system())
                open().use { link ->
                    link.wants(Wish(true, 0, null))
                    eventually(LIMIT) { ("/count" in bridge.subscribed()) shouldBe true }
                    repeat(100) { number ->
                        bridge.publish("/count", """{"data": $number, "rest": "${"x".repeat(number * 2_000)}"}""")
                        while (link.listen(LIMIT_MS)?.text != "count($number);") Unit
                        link.send("reset", SendOptions.defaults()).outcome.get(LIMIT_MS.toLong(), TimeUnit.MILLISECONDS)
                    }
                    open().use { it.send("reset", SendOptions.defaults()).outcome.get(LIMIT_MS.toLong(), TimeUnit.MILLISECONDS) }
                }
            }
        } finally {
            SSLContext.setDefault(before)
        }
    }
})
