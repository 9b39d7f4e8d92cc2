// Fault: without a percept line(_), a plan posts its own goal again at once.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); .wait(500); !follow.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!follow : argo.age(line(S), Ms) & Ms < 500 <- !send(steer(S)); .wait(400); !follow.
+!follow : line(_) <- !send(stop); .wait(400); !follow.
+!follow <- !follow. //-
//+ +!follow <- !send(stop); .wait(400); !follow.

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
