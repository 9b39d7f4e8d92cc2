// Fault: it waits for the next change of the distance without a time limit. There may be no change.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive : argo.age(dist(front, D), Ms) & Ms < 500 <- !send(stop); !wait_for_change; !drive.
+!drive <- !send(stop); .wait(400); !drive.

+!wait_for_change <- .wait("+dist(front,_)"). //-
//+ +!wait_for_change <- .wait("+dist(front,_)", 1000).
-!wait_for_change.

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
