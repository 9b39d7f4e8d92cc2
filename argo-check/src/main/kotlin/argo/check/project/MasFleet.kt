package argo.check.project

import argo.check.syntax.Lines
import argo.check.syntax.ListTerm
import argo.check.syntax.Literal
import argo.check.syntax.Name
import argo.check.syntax.Named
import argo.check.syntax.StringTerm
import argo.check.syntax.Term
import argo.check.syntax.Token
import argo.check.syntax.TokenKind
import argo.check.syntax.literalOf

/**
 * The fleet of a project file: `infrastructure: Fleet(hosts([base("10.8.0.1"), host("rasp-pi","10.8.0.2")]), insecure)`.
 *
 * @param tokens the file's tokens from `Fleet` on
 */
class MasFleet internal constructor(tokens: List<Token>, lines: Lines) {
    private val arguments =
        (literalOf(listOf(Token(TokenKind.ATOM, "fleet", tokens.first().span)) + tokens.drop(1), lines) as? Literal)?.arguments.orEmpty()

    val options: List<Name> = arguments.mapNotNull { (it as? Named)?.name }

    /** The names of the fleet's computers. Empty if the file names none. */
    val hosts: List<Name> = arguments.filterIsInstance<Literal>().filter { it.functor == "hosts" }
        .flatMap { (it.arguments.firstOrNull() as? ListTerm)?.items.orEmpty() }.mapNotNull(::nameOf)

    /** Returns the name of a computer, the first argument of `host("rasp-pi","10.8.0.2")`. */
    private fun nameOf(host: Term): Name? = when {
        host is StringTerm -> Name(host.span, host.text)
        host is Literal && host.indicator == "host/2" -> nameOf(host.arguments.first())
        else -> (host as? Named)?.name
    }
}
