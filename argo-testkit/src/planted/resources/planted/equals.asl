// Fault: it stops at exactly 30 cm. Sensors may skip this value.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : not (argo.age(dist(front, _), Ms) & Ms < 500) <- !send(stop); .wait(400); !drive.
+!drive : dist(front, D) & D > 60 <- !send(front); .wait(400); !drive.
+!drive : dist(front, 30) <- !send(stop); .wait(400); !drive. //-
//+ +!drive : dist(front, D) & D <= 30 <- !send(stop); .wait(400); !drive.
+!drive <- .wait(400); !drive.

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
