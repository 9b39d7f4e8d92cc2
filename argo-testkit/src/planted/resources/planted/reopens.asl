// Fault: if the cable is unplugged, it reopens its port itself at once. No plan handles a failure of the reopening.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

+port(P, off) <- .print("no board at ", P); !open(P).
+!open(P) <- argo.port(P).
//+ -!open(P)[error(E)] <- .print(P, ": ", E).

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
