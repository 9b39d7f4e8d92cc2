package experiment.report

/** Escapes [text] for HTML. Keeps a percent sign on the line of its number. */
internal fun escaped(text: String): String =
    text.replace(" %", "\u00a0%").replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace("\"", "&quot;")

/**
 * Makes a page without external styles or scripts. The page's colours are light or dark according to the reader's settings, and the page
 * fits a phone.
 */
internal fun page(title: String, body: String): String = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>${escaped(title)}</title>
<style>
:root {
  --ink: #1f2328; --soft: #59636e; --line: #d0d7de; --paper: #ffffff; --tint: #f6f8fa; --yes: #1a7f37; --partly: #9a6700; --no: #b3261e;
}
@media (prefers-color-scheme: dark) {
  :root {
    --ink: #e6edf3; --soft: #9198a1; --line: #3d444d; --paper: #0d1117; --tint: #151b23; --yes: #57d364; --partly: #f0b040; --no: #ff8078;
  }
}
body { margin: 0 auto; padding: 1rem; max-width: 62rem; background: var(--paper); color: var(--ink); font: 1rem/1.5 system-ui, sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; } h2 { margin-top: 2.5rem; border-bottom: 1px solid var(--line); padding-bottom: .2rem; }
h3 { margin-top: 1.6rem; }
p, li { max-width: 46rem; overflow-wrap: break-word; } .soft, figcaption { color: var(--soft); font-size: .9rem; }
figure { margin: 1rem 0; } .wide { overflow-x: auto; } .wide + .wide { margin-top: 1rem; }
.wide img { display: block; width: 100%; min-width: 44rem; height: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .7rem; border-bottom: 1px solid var(--line); text-align: left; vertical-align: top; }
td.n, th.n { text-align: right; } td { white-space: nowrap; } thead th { background: var(--tint); } tbody th { font-weight: inherit; }
.found { color: var(--yes); font-weight: 600; } .in-part { color: var(--partly); font-weight: 600; }
.not-found { color: var(--no); font-weight: 600; } .not-tested { color: var(--soft); font-weight: 600; }
caption { caption-side: top; text-align: left; color: var(--soft); font-size: .9rem; padding-bottom: .3rem;
  position: sticky; left: 0; max-width: calc(100vw - 2rem); }
section.claim { border-left: 3px solid var(--line); padding: .1rem 0 .1rem 1rem; margin: 1rem 0; } section.claim p { margin: .3rem 0; }
details { margin: .8rem 0; } summary { cursor: pointer; } code { background: var(--tint); padding: .1rem .3rem; overflow-wrap: anywhere; }
</style>
</head>
<body>
$body
</body>
</html>
"""

/** Makes a table with [heads] and a [caption] above it. The first [words] columns contain text, and the others numbers. */
internal fun table(caption: String, heads: List<String>, rows: List<List<String>>, words: Int = 1): String {
    fun cell(tag: String, scope: String, index: Int, text: String) =
        "<$tag$scope${if (index >= words) " class=\"n\"" else ""}>${escaped(text)}</$tag>"
    val head = heads.mapIndexed { i, text -> cell("th", " scope=\"col\"", i, text) }.joinToString("")
    val lines = rows.joinToString("\n") { row ->
        "<tr>" + row.mapIndexed { i, text -> if (i == 0) cell("th", " scope=\"row\"", i, text) else cell("td", "", i, text) }
            .joinToString("") + "</tr>"
    }
    return "<div class=\"wide\" tabindex=\"0\" role=\"group\" aria-label=\"table\">" +
        "<table>\n<caption>${escaped(caption)}</caption>\n<thead><tr>$head</tr></thead>\n<tbody>\n$lines\n</tbody>\n</table></div>\n"
}
