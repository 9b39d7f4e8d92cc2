package argo.view

/**
 * Keeps web pages that a browser shows elsewhere away from an agent: such a page can make its browser send requests here, under a
 * host name of its own that leads to this computer (DNS rebinding) or in the name of its visitor (CSRF).
 */
internal object RequestGate {
    private val LOOPBACK = Regex("""(127\.0\.0\.1|localhost|\[::1])(:\d{1,5})?""", RegexOption.IGNORE_CASE)

    /**
     * Returns the reason for refusing a request, in words; null: it is accepted.
     *
     * [host] may name any port, since the view may be reached through a tunnel.
     *
     * @param host the header `Host`
     * @param origin the header `Origin`, which browsers put into each request that is not a plain GET of their own
     * @param fetchSite the header `Sec-Fetch-Site`
     * @param isPage whether the page itself is asked for, which any link may do
     */
    fun refusal(host: String?, origin: String?, fetchSite: String?, isPage: Boolean): String? = when {
        host == null || !LOOPBACK.matches(host) ->
            "this view is for this computer only: open it by 127.0.0.1 or localhost, not by ${host?.let(::shown) ?: "no name"}"
        origin != null && !origin.equals("http://$host", ignoreCase = true) -> "the request comes from another page, ${shown(origin)}"
        !isPage && fetchSite != null && fetchSite != "same-origin" && fetchSite != "none" -> "the request comes from another page"
        else -> null
    }
}
