// Fault: the plan for a failed command prints the failure, and the driving loop ends there.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !drive.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!drive : argo.age(dist(front, D), Ms) & Ms < 500 & D > 30 <- argo.act(front, [timeout(500)]); .wait(500); !drive.
+!drive <- argo.act(stop, [timeout(500)]); .wait(500); !drive.
-!drive[error(E)] <- .print("failed: ", E). //-
//+ -!drive[error(E)] <- .print("failed: ", E); .wait(500); !drive.
