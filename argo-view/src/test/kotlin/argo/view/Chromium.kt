package argo.view

import io.kotest.core.test.Enabled
import org.openqa.selenium.By
import org.openqa.selenium.OutputType
import org.openqa.selenium.WindowType
import org.openqa.selenium.chrome.ChromeDriver
import org.openqa.selenium.chrome.ChromeDriverService
import org.openqa.selenium.chrome.ChromeOptions
import java.io.File
import java.net.URI
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit

/** Chromium without a window. The tests of a spec share one, since its start takes as long as some of the tests. */
internal class Chromium : AutoCloseable {
    private val driver = start()

    /** Tests the page of [address] in a new window, with the usual size and preferences. */
    suspend fun show(address: URI, test: suspend Page.() -> Unit) {
        val before = driver.windowHandles
        driver.switchTo().newWindow(WindowType.WINDOW)
        (before - driver.windowHandle).forEach { driver.switchTo().window(it).close() }
        driver.switchTo().window(driver.windowHandles.single())
        val page = Page(driver)
        page.complaints() // clears the complaints about the previous page
        driver.get("$address")
        page.test()
    }

    override fun close() = driver.quit()

    companion object {
        private val browser = program("chromium", "chromium-browser", "google-chrome")
        private val chromeDriver = program("chromedriver")

        /** Enabled if there is a Chromium here. */
        val available: Enabled = when {
            browser == null -> Enabled.disabled("needs a browser, and there is no chromium: install it with your package manager")
            chromeDriver == null ->
                Enabled.disabled("needs chromedriver beside chromium: install the package chromium-driver or chromium-chromedriver")
            else -> Enabled.enabled
        }

        private fun start(): ChromeDriver {
            val driver = checkNotNull(chromeDriver)
            val service = ChromeDriverService.Builder().usingDriverExecutable(driver).usingAnyFreePort().withSilent(true).build()
            val options = ChromeOptions().setBinary(checkNotNull(browser))
            // in a container, root has no sandbox, and /dev/shm is small
            options.addArguments("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--window-size=1280,1000")
            options.addArguments("--disable-background-networking")
            options.setCapability("goog:loggingPrefs", mapOf("browser" to "ALL"))
            return ChromeDriver(service, options)
        }

        private fun program(vararg names: String): File? =
            System.getenv("PATH").orEmpty().split(File.pathSeparator).flatMap { folder -> names.map { File(folder, it) } }
                .find { it.canExecute() }
    }
}

internal class Page(private val driver: ChromeDriver) {
    fun text(selector: String): String = driver.findElement(By.cssSelector(selector)).text

    fun texts(selector: String): List<String> = run("return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector)

    @Suppress("UNCHECKED_CAST") // the caller knows the type of its script's result
    fun <T> run(script: String, vararg arguments: Any): T = driver.executeScript(script, *arguments) as T

    fun press(words: String) = driver.findElement(By.xpath("//button[normalize-space()=\"$words\"]")).click()

    fun pressOn(selector: String) = driver.findElement(By.cssSelector(selector)).click()

    fun follow(words: String) = driver.findElement(By.linkText(words)).click()

    fun enter(selector: String, words: String) = driver.findElement(By.cssSelector(selector)).run {
        clear()
        sendKeys(words)
    }

    fun type(keys: CharSequence) = driver.switchTo().activeElement().sendKeys(keys)

    /** Sets the size of the view in CSS pixels. A window itself cannot be made as small. */
    fun size(width: Int, height: Int) {
        val metrics = mapOf("width" to width, "height" to height, "deviceScaleFactor" to 1, "mobile" to false)
        driver.executeCdpCommand("Emulation.setDeviceMetricsOverride", metrics)
    }

    /** Sets the preferences of the user, such as `prefers-color-scheme` to `dark`. */
    fun prefer(vararg features: Pair<String, String>) {
        val named = features.map { (name, value) -> mapOf("name" to name, "value" to value) }
        driver.executeCdpCommand("Emulation.setEmulatedMedia", mapOf("features" to named))
    }

    fun await(condition: Page.() -> Boolean) {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_S)
        while (!condition()) {
            check(System.nanoTime() < deadline) { "not so within $DEADLINE_S s; the page says:\n${text("body")}" }
            Thread.sleep(20)
        }
    }

    /** Writes a picture of the page, for a person, to a file of the build or in [folder]. */
    fun picture(name: String, folder: Path = Path.of("target", "view")) {
        Files.createDirectories(folder)
        Files.write(folder.resolve("$name.png"), driver.getScreenshotAs(OutputType.BYTES))
    }

    /** Returns the browser's complaints, such as a script that failed or a resource that was refused. */
    fun complaints(): String = driver.manage().logs().get("browser").all.joinToString("\n")

    private companion object {
        const val DEADLINE_S = 60L
    }
}
