package argo.view

/**
 * A project's own picture at the top of an agent's page, see [AgentView.show].
 *
 * @property svg an SVG document. The page shows it as an image, as wide as the page and 104 px high. An image runs no script and loads
 * nothing. Without a `viewBox`, its lengths are CSS pixels or percentages of the image's size.
 * @property words the caption: the picture in words
 */
data class Picture(val svg: String, val words: String)
