// Fault: it adds the belief stopped before the stop succeeds, and ignores a failure of the command.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- -stopped; !front; .wait(400); !drive.
+!drive : stopped <- .wait(400); !drive.
+!drive <- +stopped; !stop; .wait(400); !drive.

+!front <- argo.act(front, [timeout(500)]).
-!front[error(E)] <- .print("front failed: ", E).
+!stop <- argo.act(stop, [timeout(500)]).
-!stop[error(E)] <- .print("stop failed: ", E). //-
//+ -!stop[error(E)] <- -stopped; .print("stop failed: ", E).
