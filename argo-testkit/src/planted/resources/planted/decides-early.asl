// Fault: it reads the distance, waits for two seconds, and then drives by the old distance.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 100 <- .wait(2000); !onward(D); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

+!onward(D) : D > 100 <- !send(front). //-
//+ +!onward(_) : argo.age(dist(front, D), Ms) & Ms < 500 & D > 100 <- !send(front).
//+ +!onward(_) <- !send(stop).

+dist(front, D) : D < 50 <- !send(stop).
+stale(_) <- !send(stop).

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
