package argo.view

/** The files that the page is made of, which are resources of this package. */
internal enum class ViewFile(private val path: String, private val resource: String, private val type: String) {
    PAGE("/", "view.html", "text/html"),
    STYLE("/view.css", "view.css", "text/css"),
    SCRIPT("/view.js", "view.js", "text/javascript"),
    ;

    private val bytes: ByteArray by lazy {
        checkNotNull(ViewFile::class.java.getResourceAsStream(resource)) { "the resource $resource is missing beside $javaClass" }.use { it.readBytes() }
    }

    /** The file as it is served. */
    fun answer() = Answer(200, type, bytes)

    companion object {
        /** The file at [path], or null. */
        fun of(path: String): ViewFile? = entries.find { it.path == path }
    }
}
