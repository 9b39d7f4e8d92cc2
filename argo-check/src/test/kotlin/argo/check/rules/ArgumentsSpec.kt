package argo.check.rules

import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldNotBeEmpty

class ArgumentsSpec : FunSpec({
    val root = tempdir().toPath()

    fun found(text: String, rule: String = "") =
        findingsIn(root, "m.mas2j" to "MAS m { environment: E agents: bob; }", "bob.asl" to text)
            .filter { it.rule.startsWith(rule) && it.rule != "variable-once" }.map { it.inShort }

    test("a goal or a rule needs a value in an argument that all its plans or rules compare, or have a list for") {
        val fib = "!p. +!p <- !f(3,F); .print(F).\n+!f(N,0) : N == 0.\n+!f(N,F) : N > 1 <- "
        found("$fib!f(N-1,A); F = A.").shouldBeEmpty()
        found("$fib!f(A,N-1); F = A.") shouldContainExactly listOf(
            "3:24 variable-unbound: A has no value yet, and argument 1 of f/2 needs one; " +
                "bind it before, or correct the order of the arguments",
        )
        found("$fib!f(A,N-1); F = A.\n+!f(_,_).").shouldBeEmpty()
        val near = "o([1]).\nnear(P,[H|_],H) :- P <= H.\nnear(_,[H],H)."
        found("!p. +!p : o(O) & near(1,V,O) <- .print(V). $near", "variable-un") shouldContainExactly
            listOf("1:25 variable-unbound: V has no value yet, and argument 2 of near/3 needs one; " +
                "bind it before, or correct the order of the arguments")
        found("!p. +!p <- +far(4); ?far(V); .print(V).\nfar(X) :- X > 3.").shouldBeEmpty()
        found("!p. +!p <- ?far(V); .print(V).\nfar(X) :- seen(X) & X > 3.\nseen(4).").shouldBeEmpty()
        found("!p. +!p <- ?twice([1],V); .print(V).\ntwice([],[]).\ntwice([X|R],[X,X|S]) :- twice(R,S).").shouldBeEmpty()
        found("!p. +!p <- ?far(V); .print(V).\nfar(X) :- X > 3 | seen(X).\nseen(4).").shouldBeEmpty()
    }

    test("an element of .member is no list, unless the other argument is one too") {
        found("t([1]). +!m(X) : t([H|T]) & .member(T,X) <- .print(H).", "internal") shouldContainExactly listOf(
            "1:29 internal-action-arguments: argument 1 of .member is a list, and argument 2 the variable X; " +
                "correct the order of the arguments",
        )
        found("t([1]). +!m(X) : t([H|T]) & .member(X,T) <- .print(H).", "internal").shouldBeEmpty()
        found("t([1]). +!m(X) : t([H|T]) & X = [_|_] & .member(T,X) <- .print(H).", "internal").shouldBeEmpty()
        found("!m. +!m <- .member(4,[A,B]); .print(A,B).", "variable-un") shouldContainExactly listOf(
            "1:23 variable-unbound: A has no value yet, and .member needs one; bind it before, or correct the order of the arguments",
            "1:25 variable-unbound: B has no value yet, and .member needs one; bind it before, or correct the order of the arguments",
        )
    }

    test("a formula of several literals is no number, list or variable") {
        found("!m. a(1). +!m <- .count(N,(a(X) & X > 0)); .print(N).", "internal") shouldContainExactly listOf(
            "1:27 internal-action-arguments: argument 2 of .count is a number, not (a(X) & X > 0); correct the arguments, or their order",
        )
        found("!m. a(1). +!m <- .count((a(X) & X > 0),N); .print(N).", "internal").shouldBeEmpty()
        found("!m. +!m <- .wait(100,{+b}).", "internal") shouldContainExactly listOf(
            "1:22 internal-action-arguments: argument 2 of .wait is a number, not {+b}; correct the arguments, or their order",
        )
    }

    test("the class of an artifact has a name of Java's") {
        found("!m. +!m <- makeArtifact(\"c\",\"ex.Counter\",[],Id); lookupArtifact(\"c\",Id).", "internal").shouldBeEmpty()
        found("!m. +!m <- makeArtifact(\"table\",\"table\").", "internal").shouldBeEmpty()
        found("!m. +!m <- makeArtifact(\"ex.Counter\",\"c\",[],Id); .print(Id).", "internal") shouldContainExactly listOf(
            "1:25 internal-action-arguments: argument 2 of makeArtifact is the name of a Java class, and \"ex.Counter\" looks like one, " +
                "not \"c\"; correct the order of the arguments",
        )
        found("!m(\"c\"). +!m(C) <- lookupArtifact(Id,C); .print(Id).", "variable-un") shouldContainExactly listOf(
            "1:35 variable-unbound: Id has no value yet, and lookupArtifact needs one; " +
                "bind it before, or correct the order of the arguments",
        )
    }

    test("numbered atoms, and strings beside variables, tell the order of arguments") {
        val friends = (1..3).joinToString("\n") { "friend(tank$it,a$it)." } + "\n!m. +!m : friend(X,Y) <- .print(X,Y)."
        found(friends, "argument-order").shouldBeEmpty()
        found("$friends\nfriend(a4,tank4).", "argument-order") shouldContainExactly listOf(
            "5:8 argument-order: arguments 1 and 2 of friend/2 stand the other way round elsewhere in the project; correct their order",
        )
        found("!m. +!m : c(X,Y) <- +c(X-1,Y); +c(X,Y+1); +c(Y,X+1).", "argument-order") shouldContainExactly listOf(
            "1:46 argument-order: arguments 1 and 2 of c/2 stand the other way round elsewhere in the project; correct their order",
        )
        found("!m. +!m <- ?goal(\"id\",Id); ?goal(S,\"service\"); .print(Id,S).", "argument-order") shouldContainExactly listOf(
            "1:18 argument-order: arguments 1 and 2 of goal/2 stand the other way round elsewhere in the project; correct their order",
            "1:34 argument-order: arguments 1 and 2 of goal/2 stand the other way round elsewhere in the project; correct their order",
        )
    }

    test("a number that other calls have in the other place tells nothing, where each place has numbers") {
        found(
            "{ register_function(\"my.sum\",2,\"sum\") }\nsum(X,Y,X+Y).\n!m.\n" +
                "+!m <- .print(my.sum(1,2)); .print(my.sum(5,my.sum(2,my.limit))).", "argument-order",
        ).shouldBeEmpty()
        found("at(1,home). at(2,desk). !m. +!m : at(home,2) <- .print(x).", "argument-order").shouldNotBeEmpty()
    }

    test("only a relation of two, in its own rule, may be said to go both ways") {
        val roads = "near(Left,Right) :- near(Right,Left).\nnear(a,b).\n"
        found("$roads!m. +!m : near(Left,Right) & near(Left,b) <- .print(Left,Right).", "argument-order").shouldBeEmpty()
        found(
            "!m. +!m <- ?path(a,Goal,Steps,Seen); .print(Goal,Steps,Seen).\n" +
                "path(From,Goal,Steps,Seen) :- from(From) & path(From,Goal,Seen,Steps). from(a).", "argument-order",
        ) shouldContainExactly listOf(
            "2:59 argument-order: arguments 3 and 4 of path/4 stand the other way round elsewhere in the project; correct their order",
        )
    }
})
