// Fault: it has no plan for a failed command, and an unplugged cable makes a command fail.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
//+ -!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
