// Fault: it sends its speed at each change of the distance, however fast the sensor changes.
!start.

+!start <- argo.port(ttyACM0, [baud(115200)]); argo.limit(0); argo.percepts(open).
-!start[error(E)] <- .print("no board: ", E); .wait(1000); !start.

+dist(front, D) <- !show(D). //-
//+ +dist(front, D) : not resting <- +resting; !show(D); .wait(200); -resting.

+!show(D) <- argo.act(bar(D), [timeout(500)]).
-!show(D)[error(E)] <- .print("bar failed: ", E).
