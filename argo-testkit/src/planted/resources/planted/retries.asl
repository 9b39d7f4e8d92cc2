// Fault: it repeats a failed command at once. While the cable is unplugged, each attempt fails at once, so it reasons without end.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

+!send(C) : last(C).
+!send(C) <- argo.act(C, [timeout(500)]); -+last(C).
-!send(C) <- !send(C). //-
//+ -!send(C)[error(E)] <- .print(C, " failed: ", E).
