// Fault: it blocks percepts while it turns. If the turn fails, it does not open them again.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive <- !send(stop); !turn; .wait(400); !drive.

+!turn : argo.age(dist(front, D), Ms) & Ms < 500 <- argo.percepts(block); argo.act(left, [timeout(500)]); .wait(300); argo.percepts(open).
+!turn.
-!turn[error(E)] <- .print("no turn: ", E). //-
//+ -!turn[error(E)] <- argo.percepts(open); .print("no turn: ", E).

+!send(C) <- argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- .print(C, " failed: ", E).
