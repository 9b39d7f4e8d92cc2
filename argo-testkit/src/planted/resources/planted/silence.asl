// Fault: all its plans wait for changes of the distance. A silent board changes nothing.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open).
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+dist(front, D) : D > 40 & not driving <- +driving; !send(front).
+dist(front, D) : D <= 30 & driving <- -driving; !send(stop).
//+ +stale(_) <- -driving; !send(stop).
+port(_, off) <- -driving; .print("the cable is out").
+port(_, on) <- !send(stop).

+!send(C) <- argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- .print(C, " failed: ", E).
