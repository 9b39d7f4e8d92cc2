package argo.view

/**
 * A project's own picture at the top of an agent's page: see [AgentView.show].
 *
 * @property svg an SVG document. It is shown as an image, as wide as the page and 104 px high: no script in it runs, and it loads
 * nothing. Without a `viewBox` its lengths are CSS pixels and percentages of that size.
 * @property words the caption: the picture in words
 */
data class Picture(val svg: String, val words: String)
