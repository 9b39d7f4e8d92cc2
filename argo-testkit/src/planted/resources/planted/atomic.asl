// Fault: the greeting plan is atomic and waits in the middle. No other plan can run meanwhile, not even one that stops the robot.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- !send(front); .wait(400); !drive.
+!drive <- !send(stop); .wait(400); !drive.

@greet[atomic] //-
+dist(front, D) : D > 90 & D < 110 <- .print("hello"); .wait(2500); .print("nice to meet you").

// Sends a command if it differs from the last one. Prints a failure.
+!send(C) : last(C).
+!send(C) <- -+last(C); argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- -last(_); .print(C, " failed: ", E).
