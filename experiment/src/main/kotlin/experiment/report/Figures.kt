package experiment.report

import org.jetbrains.letsPlot.intern.Plot
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64

/** Writes figures into [directory]; [draw] makes SVG of them. */
internal class Figures(private val directory: Path, private val draw: (Plot) -> String = ::svg) {
    private var count = 0

    init {
        Files.createDirectories(directory)
    }

    /**
     * Writes the figure [name] as SVG and PNG. Returns HTML that shows it in light or dark colours, according to the reader's settings.
     * [instead] is the text for screen readers.
     */
    fun write(name: String, caption: String, instead: String, plot: (Shades) -> Plot): String {
        val light = draw(plot(Shades.LIGHT))
        Files.writeString(directory.resolve("$name.svg"), light)
        Files.write(directory.resolve("$name.png"), png(light))
        return """<figure><div class="wide" tabindex="0" role="group" aria-label="figure"><picture>
<source media="(prefers-color-scheme: dark)" srcset="${data(draw(plot(Shades.DARK)))}">
<img alt="${escaped(instead)}" src="${data(light)}"></picture></div>
<figcaption>Figure ${++count}. ${escaped(caption)}</figcaption></figure>
"""
    }

    private fun data(svg: String) = "data:image/svg+xml;base64," + Base64.getEncoder().encodeToString(svg.toByteArray())
}
