// Fault: each order starts another loop, and no earlier loop ends.
!start.

+!start <- argo.port(ttyACM0); argo.limit(100); argo.percepts(open).
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+!blink(C)[source(S)] : S \== self <- !!blinking(C). //-
//+ +!blink(C)[source(S)] : S \== self <- .drop_intention(blinking(_)); !!blinking(C).

+!blinking(C) <- !send(C); .wait(250); !blinking(C).

+!send(C) <- argo.act(C, [timeout(500)]).
-!send(C)[error(E)] <- .print(C, " failed: ", E).
