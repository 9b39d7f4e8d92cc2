package argo.view

/**
 * Keeps foreign web pages in a browser away from an agent. A foreign page can make its browser send requests to this server. The page may
 * use its own host name, which leads to this computer (DNS rebinding), or its visitor's name (CSRF).
 */
internal object RequestOrigin {
    private val LOOPBACK = Regex("""(127\.0\.0\.1|localhost|\[::1])(:\d{1,5})?""", RegexOption.IGNORE_CASE)

    /**
     * Returns the reason for refusing a request, in words; null if it is accepted.
     *
     * [host] may name any port, since the view may be behind a tunnel.
     *
     * @param host the header `Host`
     * @param origin the header `Origin`, which browsers send with every request except plain GETs of the page itself
     * @param fetchSite the header `Sec-Fetch-Site`
     * @param isPage whether the request is for the page itself, to which any link may lead
     */
    fun refusal(host: String?, origin: String?, fetchSite: String?, isPage: Boolean): String? = when {
        host == null || !LOOPBACK.matches(host) ->
            "this view is for this computer only: open it by 127.0.0.1 or localhost, not by ${host?.let(::shown) ?: "no name"}"
        origin != null && !origin.equals("http://$host", ignoreCase = true) -> "the request comes from another page, ${shown(origin)}"
        !isPage && fetchSite != null && fetchSite != "same-origin" && fetchSite != "none" -> "the request comes from another page"
        else -> null
    }
}
