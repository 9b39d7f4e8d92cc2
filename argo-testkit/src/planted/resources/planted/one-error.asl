// Fault: its failure plan handles only an unplugged cable. If the board hangs, the command fails with another error.
!start.

+!start <- argo.port(ttyACM0, [protocol(2)]); argo.limit(100); argo.percepts(open); !drive.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(port_gone)] <- -last(_); .print(C, " failed: the cable is out").
//+ -!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
