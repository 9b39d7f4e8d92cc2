// Fault: driving and stopping use one threshold. If a sensor flickers there, the robot starts and stops all the time.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open).
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+dist(front, D) : D < 30 <- !send(stop).
+dist(front, D) <- !send(front). //-
//+ +dist(front, D) : D > 60 & not resting <- +resting; !send(front); .wait(1000); -resting.
+stale(_) <- !send(stop).
+port(_, off) <- .print("the cable is out").
+port(_, on) <- !send(stop).

+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
