// Makes turtlesim spawn a second turtle, and drives the first one to it.

!start.

+!start : board(Port) <-
    argo.port(Port);
    argo.limit(50);
    !other;
    argo.percepts(open).
-!start[error_msg(Why)] <- .print(Why); .stopMAS(0, 1).

+!other <- argo.act(spawn(9, 8, 0), [answer(Name)]); .print("goes to ", Name). // the answer of the service
-!other <- .print("goes to the one that is there"). // from an earlier run

// The distances in m from the first turtle to the other one, ahead and to the left.
ahead(D) :- pose(X, Y, H) & other(A, B) & D = (A - X) * math.cos(H) + (B - Y) * math.sin(H).
left(D)  :- pose(X, Y, H) & other(A, B) & D = (B - Y) * math.cos(H) - (A - X) * math.sin(H).

+pose(_, _, _) : not there & ahead(A) & left(L) <- !go(A, L).
+other(_, _)   : not there & ahead(A) & left(L) <- !go(A, L). // in case the other turtle is seen after the first one

+!go(A, L) : A * A + L * L < 0.25 <- +there; argo.act(stop); .print("is there"); .stopMAS.
+!go(A, L) : A > 0 <- argo.act(drive(A, 4 * L / (A + 1)), [latest]).
+!go(_, L) : L < 0 <- argo.act(drive(0, -2), [latest]). // turns until the other turtle is ahead
+!go(_, _)         <- argo.act(drive(0, 2), [latest]).
-!go(_, _)[error(E), error_msg(Why)] : E \== act_replaced <- .print(E, ": ", Why); .stopMAS(0, 1).
-!go(_, _). // a newer speed has replaced this one
