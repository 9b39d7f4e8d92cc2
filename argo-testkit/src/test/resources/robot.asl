{ include("inc/engine.asl") }

!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open).

+dist(front,X) : X < 40 <- !halt.
+dist(front,X)          <- !drive.
+port(P,S)              <- .print("port ", P, " is ", S).
