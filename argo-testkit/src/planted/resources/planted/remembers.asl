// Fault: it keeps each distance with a number to compute a mean, and forgets none.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

count(0).

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

+dist(front, D) : count(N) <- -+count(N + 1); +seen(N, D). //-
//+ +dist(front, D) : count(N) <- -+count(N + 1); .abolish(seen(N - 10, _)); +seen(N, D).

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
