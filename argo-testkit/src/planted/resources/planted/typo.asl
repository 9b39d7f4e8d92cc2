// Fault: a rarely used plan sends turnleft, which the board does not know. The board calls the action left.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 50 <- !send(front); .wait(400); !drive.
+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 40 <- !send(turnleft); .wait(400); !drive. //-
//+ +!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 40 <- !send(left); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
