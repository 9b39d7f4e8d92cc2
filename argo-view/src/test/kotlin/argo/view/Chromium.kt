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

/** Chromium without a window, for the tests of a spec: starting it takes as long as some of them. */
internal class Chromium : AutoCloseable {
    private val driver = start()

    /** Tests the page of [address] in a window of its own, whose size and preferences are those of a new one. */
    suspend fun show(address: URI, test: suspend Page.() -> Unit) {
        val before = driver.windowHandles
        driver.switchTo().newWindow(WindowType.WINDOW)
        (before - driver.windowHandle).forEach { driver.switchTo().window(it).close() }
        driver.switchTo().window(driver.windowHandles.single())
        val page = Page(driver)
        page.complaints() // of the page before
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
            // a container's root has no sandbox to use, and a small /dev/shm
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

/** The page in [driver]'s window. */
internal class Page(private val driver: ChromeDriver) {
    /** Returns the text of the first element that [selector] finds. */
    fun text(selector: String): String = driver.findElement(By.cssSelector(selector)).text

    /** Returns the texts of the elements that [selector] finds. */
    fun texts(selector: String): List<String> = run("return [...document.querySelectorAll(arguments[0])].map(e => e.textContent)", selector)

    /** Returns the result of [script]. */
    @Suppress("UNCHECKED_CAST") // the caller knows the type of its script's result
    fun <T> run(script: String, vararg arguments: Any): T = driver.executeScript(script, *arguments) as T

    /** Presses the button that says [words]. */
    fun press(words: String) = driver.findElement(By.xpath("//button[normalize-space()=\"$words\"]")).click()

    /** Presses the first button that [selector] finds. */
    fun pressOn(selector: String) = driver.findElement(By.cssSelector(selector)).click()

    /** Follows the link that says [words]. */
    fun follow(words: String) = driver.findElement(By.linkText(words)).click()

    /** Puts [words] into the field that [selector] finds. */
    fun enter(selector: String, words: String) = driver.findElement(By.cssSelector(selector)).run {
        clear()
        sendKeys(words)
    }

    /** Presses keys. */
    fun type(keys: CharSequence) = driver.switchTo().activeElement().sendKeys(keys)

    /** Sets the size of the view in CSS pixels; a window itself has a least width. */
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
    fun await(condition: Page.() -> Boolean) {
        val deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(DEADLINE_S)
        while (!condition()) {
            check(System.nanoTime() < deadline) { "not so within $DEADLINE_S s; the page says:\n${text("body")}" }
            Thread.sleep(20)
        }
    }

    /** Writes a picture of the page to a file of the build, or in [folder], for a person to look at. */
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
