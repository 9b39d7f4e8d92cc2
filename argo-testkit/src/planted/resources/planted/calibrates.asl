// Fault: it waits for the percept place(home) without a time limit. A board that restarts meanwhile never sends it.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !work.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

// The board reports the place of the arm. If it has lost the place, the arm drives home.
+!work : place(lost) <- !home; .wait(500); !work.
+!work <- .wait(500); !work.

+!home <- argo.act(home); .wait("+place(home)"). //-
//+ +!home <- argo.act(home); .wait("+place(home)", 3000).
-!home <- .print("the arm does not find home").
