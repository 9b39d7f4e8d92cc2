// Fault: it catches the failure of a command to keep the console clean. Nobody learns of the failure.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open).
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!lamp(C) <- argo.act(C).
-!lamp(_). //-
//+ -!lamp(C)[error(E)] <- .print(C, " failed: ", E).
