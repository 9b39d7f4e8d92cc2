// Planted: it waits for the answer to a command without a time limit. A board that restarts meanwhile never gives it.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open); !work.
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

// Where the arm is, the board says itself; when it has lost its place the arm is sent home.
+!work : place(lost) <- !home; .wait(500); !work.
+!work <- .wait(500); !work.

+!home <- argo.act(home); .wait("+place(home)"). //-
//+ +!home <- argo.act(home); .wait("+place(home)", 3000).
-!home <- .print("the arm does not find home").
