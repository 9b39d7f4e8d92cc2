package argo.check.rules

import argo.check.ProjectCheck
import argo.check.findings.Level
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class ProgramRulesSpec : FunSpec({
    val root = tempdir().toPath()
    val mas = "m.mas2j" to "MAS m { agents: bob; eve; }"
    fun found(text: String, vararg others: Pair<String, String>) =
        findingsIn(root, mas, "bob.asl" to text, "eve.asl" to "", *others).filter { "${it.place.file}".endsWith("bob.asl") &&
            it.level != Level.HINT }.map { it.inShort }

    context("a slip is found in its line") {
        listOf(
            "!strat.\n+!start <- .print(a)." to "1:2 goal-without-plan: no plan is for the goal strat/0; did you mean start?",
            "!start.\n+!strat <- .print(a)." to
                "2:3 plan-without-cause: nothing in the project posts the goal strat/0; did you mean start?",
            "!go(1).\n+!go(X,Y) <- .print(X,Y)." to
                "1:2 goal-arity: no plan is for the goal go/1: the plans are for go/2; correct the arguments",
            "+dist(X) : limti(L) & X > L <- .print(X).\nlimit(3).\n+limit(_) <- .print(x)." to
                "1:12 belief-unknown: limti/1 is read and never believed; did you mean limit?",
            "!a.\n+!a <- +coutn(1).\n+count(X) <- .print(X)." to
                "2:9 belief-unread: coutn/1 is believed and never read; did you mean count?",
            "!a.\n+!a : tre <- .print(x)." to "2:7 belief-unknown: tre/0 is read and never believed; did you mean true?",
            "!a.\n+!a <- .prnit(x)." to "2:8 internal-action: there is no internal action .prnit; did you mean .print?",
            "!a.\n+!a <- .nth(1)." to "2:8 internal-action-arguments: .nth has 1 arguments; it takes 3 arguments",
            "!a.\n+!a <- .send(eve, tel, b)." to "2:19 performative: tel is no performative of Jason; did you mean tell?",
            "!a.\n+!a <- .send(eev, tell, b)." to "2:14 receiver: there is no agent eev; did you mean eve?",
            "!a.\n+!a : p(Distance) <- .print(Distanc)." to
                "2:29 variable-once: the variable Distanc occurs once here; did you mean Distance?",
            "!a.\n+!a <- move(1); mvoe(2); move(3)." to
                "2:17 action-unknown: no action of the environment is called mvoe; did you mean move?",
            "!a.\n-!a[error(no_such_prt)] <- .print(x).\n+!a <- argo.port(x)." to
                "2:5 error-atom: no action fails with error(no_such_prt); did you mean error(no_such_port)?",
            "!a.\n+!a <- .print(x).\n+!a : b <- .print(y).\nb." to
                "3:1 plan-unreachable: the plan in line 2 always applies to this event, and comes first; " +
                "move it up, or give the other a context",
            "!a.\n!go(3,eve).\n+!a : .my_name(Me) & .length([1],N) <- !go(Me,N).\n+!go(A,B) <- .print(A,B)." to
                "3:44 argument-order: arguments 1 and 2 of go/2 stand the other way round elsewhere in the project; correct their order",
            "pos(front,1).\npos(back,2).\n!a.\n+!a : pos(3,front) <- .print(x)." to
                "4:11 argument-order: arguments 1 and 2 of pos/2 stand the other way round elsewhere in the project; correct their order",
            "!a.\n+!a <- .suspend(gp(1)); !gop(1).\n+!gop(X) <- .print(X)." to
                "2:17 goal-unknown: the agent has no goal gp/1; did you mean gop?",
        ).forEach { (text, finding) -> test("in $text") { withClue(found(text)) { found(text) shouldContain finding } } }
    }

    context("what may come from elsewhere is not told of") {
        listOf(
            "+tick(X) <- .print(X).",
            "+!go(X) : ready <- .print(X).",
            "!a.\n+!a <- !b(1).\n{ include(\"other.asl\") }",
            "!a.\n+!a <- .add_plan(P); !b(1); .print(P).",
            "+!kqml_received(S, ask, C, M) <- .print(S, C, M).",
            "!a.\n+!a : pos1(X) & pos2(X) <- .print(X).\npos2(1).",
            "+closed <- .print(x). // argo: others may send closed, opened\n+opend <- .print(y). // argo: ignore\nopened.",
            "!a. +!a : b(X,Y) & b(Y,X) <- .print(X,Y). b(1,2).",
            "!a. +!a <- .wait({+dista(X)}); .print(X).\n+dist(X) <- .print(X).",
            "!a. +!a <- .print(math.sqrt(.length([1]))).",
            "!a. +!a <- my.actino(1).",
            "!a. +!a <- in(ticket); inc; inc.",
        ).forEach { text -> test("in $text") { found(text).shouldBeEmpty() } }
    }

    test("what other agents send is believed and posted, and what they await is sent") {
        val eve = "eve.asl" to "!a. +!a <- .send(bob, tell, price(3)); .send(bob, achieve, sell(1)). +offer(X) <- .print(X)."
        fun of(bob: String) = findingsIn(root, mas, "bob.asl" to bob, eve).filter { it.level != Level.HINT &&
            "${it.place.file}".endsWith("bob.asl") }.map { it.inShort }
        of("+price(X) : X < 4 <- .send(eve, tell, offer(X)). +!sell(X) <- .print(X).").shouldBeEmpty()
        of("+prcie(X) : X < 4 <- .send(eve, tell, offre(X)).") shouldContainExactly listOf(
            "1:2 belief-unknown: prcie/1 is awaited and never believed; did you mean price?",
            "1:39 belief-unread: no agent of the project reads offre/1; did you mean offer?",
        )
    }

    test("a receiver that no agent is is told of, if all agents are known") {
        fun of(text: String, vararg others: Pair<String, String>) = found("!a. +!a <- .send(tom, tell, b). $text", *others)
        of("") shouldContainExactly listOf("1:18 receiver: there is no agent tom; there are bob, eve")
        of("+!b <- .create_agent(X, \"eve.asl\"); .print(X).").filter { "receiver" in it }.shouldBeEmpty()
        of("", "Env.java" to "class Env { void a() { getRuntimeServices().createAgent(name()); } }").shouldBeEmpty()
        of("", "p.jcm" to "mas m { }").shouldBeEmpty()
        found("!a. +!a <- .send(self, achieve, a).").shouldBeEmpty()
    }

    test("names that nothing knows are hints, if all that could bring them is in the project") {
        val program = "!a.\nready.\n+!a : clear <- .print(x).\n+!b <- .print(y)."
        val hints = listOf(
            "2:1 belief-unread: ready/0 is believed and never read; read it, or remove it",
            "3:7 belief-unknown: clear/0 is read and never believed; believe it, or say that others may send it",
            "4:3 plan-without-cause: nothing in the project posts the goal b/0; post the goal, or remove the plan",
        )
        fun of(mas: String, vararg others: Pair<String, String>) =
            findingsIn(root, "m.mas2j" to mas, "bob.asl" to program, *others).map { it.inShort }
        of("MAS m { agents: bob; }") shouldContainExactly hints
        of("MAS m { environment: Env agents: bob; }", "Env.java" to "class Env { }") shouldContainExactly hints
        of("MAS m { environment: Env agents: bob; }").shouldBeEmpty()
        of("MAS m { agents: bob agentClass a.Bob; }", "a/Bob.java" to "class Bob { }").shouldBeEmpty()
        of("MAS m { infrastructure: Jade agents: bob; }").shouldBeEmpty()
        of("MAS m { agents: bob; }", "p.jcm" to "mas m { }").shouldBeEmpty()
    }

    test("two variables that stand side by side in one order, and once in the other, are a hint") {
        val others = "+!go(Left,Right) <- .print(Left,Right).\n+!turn(Left,Right) <- .print(Left,Right).\n"
        fun of(text: String) = findingsIn(root, mas, "eve.asl" to "", "bob.asl" to others + text).filter { it.rule == "argument-order" }
            .map { it.inShort }
        of("+!run(Left,Right) <- move(Right,Left).").single() shouldBe
            "3:27 argument-order: Left stands in front of Right in 2 other plans, and here behind it; " +
            "correct their order, if it is not meant"
        of("side(Left,Right) :- side(Right,Left).").shouldBeEmpty()
        of("+!run(Left,Right) <- move(Right,Left). +!back(Left,Right) <- move(Right,Left).").shouldBeEmpty()
    }

    test("a file that is no text has one error, and of more than 20 errors only the first are told") {
        found("a(\uFFFD\uFFFD).\n\uFFFD.\n+a(1) <- .print(1).") shouldContainExactly
            listOf("1:3 syntax: this is no text in UTF-8; correct it; the rest of the file is checked as far as it can be read")
        val many = found("\u0001".repeat(50)).filter { "syntax" in it }
        many.size shouldBe 21
        many.last() shouldBe "1:21 syntax: from here on are 30 more errors; correct the first ones, and check again"
    }

    test("names in the project's Java are known, and are what was meant") {
        val java = "Env.java" to
            "class Env { void a() { addPercept(Literal.parseLiteral(\"lamp(on)\")); if (a.getFunctor().equals(\"burn\")) b(); } }"
        found("+lamp(X) <- burn(X).", java).shouldBeEmpty()
        found("+lmap(X) <- brun(X).", java) shouldContainExactly listOf(
            "1:2 belief-unknown: lmap/1 is awaited and never believed; did you mean lamp?",
            "1:13 action-unknown: no action of the environment is called brun; did you mean burn?",
        )
    }

    test("a variable that occurs once is a hint, without a name that it is nearly") {
        val findings = findingsIn(root, mas, "eve.asl" to "",
            "bob.asl" to "+dist(Side, Cm) : Cm < 3 <- .print(Cm).\n+a(_, _Unused) <- .print(x).").filter { it.rule == "variable-once" }
        findings.map { "${it.level} ${it.inShort}" } shouldContainExactly
            listOf("HINT 1:7 variable-once: the variable Side occurs once here; write _ if that is meant")
    }

    test("a check of another text of one program says nothing of the text that is gone") {
        val project = projectOf(root, mas, "eve.asl" to "", "bob.asl" to "!strat. +!start <- .print(x).")
        val bob = project.programs.keys.single { "$it".endsWith("bob.asl") }
        val mended = project.with(bob, "!start. +!start <- .print(x).")
        ProjectCheck(mended).findingsIn(mended.programs.getValue(bob)).shouldBeEmpty()
        ProjectCheck(project).findings().size shouldBe 2
    }

    test("no text makes a check throw") {
        val parts = Arb.element(
            ".argo.port(", ".limit(", "percepts(", ".act(", ".filter(", "port(", "source(", "a", "X", "true", "9", "-", ",", ")", "[", "]",
            "(", "\"s\"", "'", ";", ".", "\n", "agents:", "agentArchClass", "ag-arch:", "infrastructure:", "{", "}", "only", "MAS m {",
            "on", "Centralised", "+!g", "<-", ".send(", "tell", ".at(", "#", "argo_view=", "error(", "@p", ".member(", "|", "as(",
            "argo.act(",
        )
        val project = projectOf(root, mas, "bob.asl" to "", "eve.asl" to "", "percepts" to "dist(cm 0..400)",
            "b.ino" to "javino.act[\"stop\"] = stop;")
        val bob = project.programs.keys.first()
        checkAll(Arb.list(parts, 0..30)) {
            val text = it.joinToString("")
            val other = project.with(bob, text).copy(projectFiles = listOf(argo.check.project.MasFile(bob, text)))
            ProjectCheck(other).findings()
        }
    }
})
