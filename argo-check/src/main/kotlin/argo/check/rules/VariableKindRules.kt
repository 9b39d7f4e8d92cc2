package argo.check.rules

/** Variables of two kinds of term in a plan. For example, an internal action needs a list, but the rest of the plan uses a number. */
internal object VariableKindRules : Rule {
    override fun check(scene: Scene, report: Report) = scene.program.program.components.forEach { component ->
        val uses = KindOfUse.within(component).filter { it.kind in WORDS }.toList().groupBy { it.variable }
        uses.values.forEach { same -> same.filter { it.call != null }.forEach { contradiction(it, same, report) } }
    }

    private fun contradiction(use: KindOfUse, all: List<KindOfUse>, report: Report) {
        val others = all.filter { it.call !== use.call || it.call == null }.map { it.kind }.toSet() - EITHER
        val other = others.singleOrNull() ?: return
        if (other == use.kind || use.kind == EITHER && other != NUMBER || use.kind == NUMBER && other == STRING || use.kind == STRING &&
            other == NUMBER) return
        report.warning(
            "internal-action-arguments", use.term.span,
            "${use.variable} is ${WORDS[other]} elsewhere in this plan, and this argument of ${use.call?.name} is ${WORDS[use.kind]}",
            "the plan fails there", "correct the arguments, or their order",
        )
    }

    private const val NUMBER = 'n'
    private const val STRING = 's'
    private const val EITHER = 'e'
    private val WORDS = mapOf('l' to "a list", NUMBER to "a number", STRING to "a string", EITHER to "a list or a string")
}
