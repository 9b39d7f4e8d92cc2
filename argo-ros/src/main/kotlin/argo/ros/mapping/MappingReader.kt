package argo.ros.mapping

import argo.filters.Problem

private const val FORM = "expected 'percepts:' or 'commands:', and below them lines that begin with '- '"

/**
 * Reads a mapping. Mappings use a part of the YAML syntax: comments, and the keys `percepts` and `commands`. Each key has a list of plain
 * one-line texts.
 *
 * @throws MappingException with all problems of the mapping
 */
internal fun mappingOf(text: String, source: String): Mapping {
    val percepts = ArrayList<PerceptRule>()
    val commands = ArrayList<CommandRule>()
    val problems = ArrayList<Problem>()
    var section: String? = null
    text.removePrefix("\uFEFF").lines().forEachIndexed { index, line ->
        try {
            val place = Place(index + 1, 1)
            val item = itemIn(line, place)
            when {
                item == null -> sectionIn(line, place)?.let { section = it }
                section == "percepts" -> percepts += perceptRuleOf(item.text, item.place)
                section == "commands" -> commands += commandRuleOf(item.text, item.place)
                else -> throw Refusal(item.place, "$FORM; this item is below neither")
            }
        } catch (refusal: Refusal) {
            problems += Problem(source, refusal.place.line, refusal.place.column, refusal.message.orEmpty())
        }
    }
    commands.groupBy { it.name to it.parameters.size }.values.filter { it.size > 1 }.forEach { (first, second) ->
        val command = "${second.name}/${second.parameters.size}"
        val message = "the command $command stands in line ${first.place.line} already"
        problems += Problem(source, second.place.line, second.place.column, message)
    }
    percepts.groupBy { it.topic }.values.forEach { rules ->
        rules.find { it.type != rules[0].type }?.let {
            val message = "the topic ${it.topic} has the type ${rules[0].type} in line ${rules[0].place.line}, and not ${it.type}"
            problems += Problem(source, it.place.line, it.place.column, message)
        }
    }
    if (percepts.isEmpty() && commands.isEmpty() && problems.isEmpty()) problems += Problem(source, 1, 1, "it is empty; $FORM")
    if (problems.isNotEmpty()) throw MappingException(problems)
    return Mapping(source, percepts, commands)
}

private class Item(val text: String, val place: Place)

/** A comment may contain tabs or follow tabs. */
private val COMMENT = Regex("(^|[ \t]+)#.*")
private val ITEM = Regex("( *)- +(.*)")
private val KEY = Regex("([A-Za-z_]+) *:(.*)")

private fun itemIn(line: String, start: Place): Item? {
    val tabulator = line.replace(COMMENT, "").indexOf('\t')
    if (tabulator >= 0) {
        throw Refusal(Place(start.line, tabulator + 1), "expected blanks, but found a tabulator")
    }
    val match = ITEM.matchEntire(line) ?: return null
    val text = match.groups[2] ?: return null
    val place = Place(start.line, text.range.first + 1)
    val plain = text.value.replace(COMMENT, "").trimEnd()
    return when {
        plain.isEmpty() -> throw Refusal(place, "the item is empty")
        plain[0] in "\"'[{&*!|>%@`" -> throw Refusal(place, "an item does not begin with ${plain[0]}; write it without quotes, in one line")
        ": " in plain || plain.endsWith(":") -> throw Refusal(
            Place(start.line, place.column + plain.indexOf(":")), "an item has no ':'; a field is given a value by '='",
        )
        else -> Item(plain, place)
    }
}

private fun sectionIn(line: String, place: Place): String? {
    val plain = line.replace(COMMENT, "").trimEnd()
    if (plain.isEmpty() || plain == "---") return null
    val (key, rest) = KEY.matchEntire(plain)?.destructured ?: throw Refusal(place, "$FORM, but found '${plain.trim().take(MAX_QUOTED)}'")
    if (key != "percepts" && key != "commands") throw Refusal(place, "$FORM, but found '$key:'")
    if (rest.isNotBlank()) throw Refusal(place, "expected nothing behind '$key:', but found '${rest.trim().take(MAX_QUOTED)}'")
    return key
}

private const val MAX_QUOTED = 40
