// Fault: each change of the distance starts an intention that lasts five seconds.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

+dist(front, D) <- .wait(5000); .print("five seconds ago it was ", D). //-
//+ +dist(front, D) <- .print("it is ", D).

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
