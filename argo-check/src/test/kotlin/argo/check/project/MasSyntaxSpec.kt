package argo.check.project

import argo.check.rules.findingsIn
import argo.check.rules.inShort
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import jason.mas2j.parser.ParseException
import jason.mas2j.parser.TokenMgrError
import jason.mas2j.parser.mas2j
import java.io.StringReader

class MasSyntaxSpec : FunSpec({
    val root = tempdir().toPath()
    fun found(text: String) =
        findingsIn(root, "m.mas2j" to text, "a.asl" to "", "b.asl" to "").filter { it.rule == "syntax" }.map { it.inShort }
    fun isReadByJason(text: String) = try {
        mas2j(StringReader(text)).mas()
        true
    } catch (_: ParseException) {
        false
    } catch (_: TokenMgrError) {
        false
    }

    context("what Jason refuses is told at the first token that does not fit") {
        listOf(
            "" to "1:1 MAS, not the end of the file",
            "mas m { agents: a; }" to "1:1 MAS, not mas",
            "MAS { agents: a; }" to "1:5 the name of the system, in lower case, not {",
            "MAS M { agents: a; }" to "1:5 the name of the system, in lower case, not M",
            "MAS m agents: a; }" to "1:7 {, not agents",
            "MAS m { agents a; }" to "1:16 :, not a",
            "MAS m { agents: }" to "1:17 the name of an agent, in lower case, not }",
            "MAS m { agents: a }" to "1:19 ;, not }",
            "MAS m { agents: a; b }" to "1:22 ;, not }",
            "MAS m { agents: a b c; }" to "1:21 ;, not c",
            "MAS m { agents: a" to "1:18 $PROGRAM, not the end of the file",
            "MAS m { agents: a \"b.asl\"; }" to "1:19 $PROGRAM, not \"b.asl\"",
            "MAS m { agents: a Bob.asl; }" to "1:19 $PROGRAM, not Bob",
            "MAS m { agents: a test-b.asl; }" to "1:19 $PROGRAM, not test",
            "MAS m { agents: a src/b.asl; }" to "1:19 $PROGRAM, not src",
            "MAS m { agents: a ../b.asl; }" to "1:19 $PROGRAM, not .",
            "MAS m { agents: a = b; }" to "1:19 $PROGRAM, not =",
            "MAS m { agents: a agentArchClass argo.Arch\n b; }" to "2:2 ;, not b",
            "MAS m { agents: a [verbose=1] b; }" to "1:31 ;, not b",
            "MAS m { agents: a [argo_percepts=-3]; }" to "1:34 $VALUE, not -",
            "MAS m { agents: a [argo_record=drive.mcap]; }" to "1:32 $VALUE, not drive.mcap",
            "MAS m { agents: a [x='y']; }" to "1:22 $VALUE, not 'y'",
            "MAS m { agents: a [x=1 y=2]; }" to "1:24 ] or ,, not y",
            "MAS m { agents: a [X=1]; }" to "1:20 the name of an option, not X",
            "MAS m { agents: a [x]; }" to "1:21 =, not ]",
            "MAS m { agents: a []; }" to "1:20 the name of an option, not ]",
            "MAS m { agents: a #x; }" to "1:20 a number, not x",
            "MAS m { agents: a;" to "1:19 the name of an agent, in lower case, not the end of the file",
            "MAS m { infrastructure: Local" to "1:30 a section, as agents, or }, not the end of the file",
            "MAS m { foo: x agents: a; }" to "1:9 a section, as agents, or }, not foo",
        ).forEach { (text, what) ->
            test("in '$text'") {
                isReadByJason(text) shouldBe false
                withClue(found(text)) { found(text) shouldBe listOf(what.replaceFirst(" ", " syntax: here should be ") + "; correct it") }
            }
        }
    }

    context("what Jason reads is not told of") {
        listOf(
            "MAS m { agents: a; b; }", "MAS m { }",
            "MAS m { agents: a /d/e.asl #3; b ./c.asl; c c:/x/y.asl; d e[verbose=1]; f g.txt; }",
            "MAS m { agents: a b.asl [verbose=1,x=\"y;}\"] agentArchClass argo.Arch #2 at \"h\"; b; }",
            "MAS m { infrastructure: Local environment: x.Y(1,\"b\") agents: a agentClass x.B(2, 3) beliefBaseClass c.D; " +
                "aslSourcePath: \"x\"; }",
            "MAS m { agents: a beliefBaseClass x.C(y.D, z.E(\"p(k,_)\"), [1,[q.R(2)]]); b [verbose=1] agentClass v.W(); }",
            "MAS m { agents: a [events=discard,intBels=newFocus,nrcbp=3,verbose=2]; }",
            "MAS m { agents: a [synchronised=true]; }", "MAS m { agents: a [x=Xy, z_1=true]; }", "MAS m { agents: a [y=1.5]; }",
            "/* c */ MAS m { agents: a; directives: d=x.Y; } x",
        ).forEach { text ->
            test("in '$text'") {
                isReadByJason(text) shouldBe true
                found(text) shouldBe emptyList()
            }
        }
    }
})

private const val PROGRAM = "a program in lower case, as bob.asl or ./src/bob.asl, or ;"
private const val VALUE = "a name, a number without a sign, or a text in quotes"
