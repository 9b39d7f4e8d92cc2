package argo.view

import io.kotest.core.test.Enabled
import org.openqa.selenium.By
import org.openqa.selenium.OutputType
import org.openqa.selenium.chrome.ChromeDriver
import org.openqa.selenium.chrome.ChromeDriverService
import org.openqa.selenium.chrome.ChromeOptions
import java.io.File
import java.net.URI
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** Chromium without a window, showing [address]. */
internal class Chromium private constructor(private val driver: ChromeDriver, private val address: URI) : AutoCloseable {
    init {
        driver.get("$address")
    }

    /** What the first element that [selector] finds says. */
    fun text(selector: String): String = driver.findElement(By.cssSelector(selector)).text

    /** What the elements say that [selector] finds. */
    fun texts(selector: String): List<String> = run("return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector)

    /** What [script] returns. */
    @Suppress("UNCHECKED_CAST") // the script's own business
    fun <T> run(script: String, vararg arguments: Any): T = driver.executeScript(script, *arguments) as T

    /** Presses the button that says [words]. */
    fun press(words: String) = driver.findElement(By.xpath("//button[normalize-space()=\"$words\"]")).click()

    /** Follows the link that says [words]. */
    fun follow(words: String) = driver.findElement(By.linkText(words)).click()

    /** Puts [words] into the field that [selector] finds. */
    fun enter(selector: String, words: String) = driver.findElement(By.cssSelector(selector)).run {
        clear()
        sendKeys(words)
    }

    /** Presses keys. */
    fun type(keys: CharSequence) = driver.switchTo().activeElement().sendKeys(keys)

    /** Sets the size of what is seen, in CSS pixels, which a window has a least width for. */
    fun size(width: Int, height: Int) {
        val metrics = mapOf("width" to width, "height" to height, "deviceScaleFactor" to 1, "mobile" to false)
        driver.executeCdpCommand("Emulation.setDeviceMetricsOverride", metrics)
    }

    /** Sets the preferences of the person who looks, such as `prefers-color-scheme` to `dark`. */
    fun prefer(vararg features: Pair<String, String>) {
        val named = features.map { (name, value) -> mapOf("name" to name, "value" to value) }
        driver.executeCdpCommand("Emulation.setEmulatedMedia", mapOf("features" to named))
    }

    /** Waits until [condition] holds of the page. */
    fun await(condition: Chromium.() -> Boolean) {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_S)
        while (!condition()) {
            check(System.nanoTime() < deadline) { "not so within $DEADLINE_S s; the page says:\n${text("body")}" }
            Thread.sleep(20)
        }
    }

    /** Writes what is seen to a file of the build, or in [folder], for a person to look at. */
    fun picture(name: String, folder: Path = Path.of("target", "view")) {
        Files.createDirectories(folder)
        Files.write(folder.resolve("$name.png"), driver.getScreenshotAs(OutputType.BYTES))
    }

    /** What the browser complains of, such as a script that failed or a resource that was refused. */
    fun complaints(): String = driver.manage().logs().get("browser").all.joinToString("\n")

    override fun close() = driver.quit()

    companion object {
        private const val DEADLINE_S = 30L
        private val browser = program("chromium", "chromium-browser", "google-chrome")
        private val chromeDriver = program("chromedriver")

        /** Whether there is one here. */
        val available: Enabled = when {
            browser == null -> Enabled.disabled("needs a browser, and there is no chromium: install it with your package manager")
            chromeDriver == null ->
                Enabled.disabled("needs chromedriver beside chromium: install the package chromium-driver or chromium-chromedriver")
            else -> Enabled.enabled
        }

        fun open(address: URI): Chromium {
            val driver = checkNotNull(chromeDriver)
            val service = ChromeDriverService.Builder().usingDriverExecutable(driver).usingAnyFreePort().withSilent(true).build()
            val options = ChromeOptions().setBinary(checkNotNull(browser))
            // a container's root has no sandbox to use, and a small /dev/shm
            options.addArguments("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--window-size=1280,1000")
            options.addArguments("--disable-background-networking")
            options.setCapability("goog:loggingPrefs", mapOf("browser" to "ALL"))
            return Chromium(ChromeDriver(service, options), address)
        }

        private fun program(vararg names: String): File? =
            System.getenv("PATH").orEmpty().split(File.pathSeparator).flatMap { folder -> names.map { File(folder, it) } }
                .find { it.canExecute() }
    }
}
