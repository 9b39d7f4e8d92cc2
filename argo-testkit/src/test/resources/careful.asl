!start.

+!start <- argo.port(ttyACM0, [protocol(2)]); argo.limit(100); argo.change_filter(careful); argo.percepts(open).

+!go : argo.age(dist(front,_), Ms) & Ms < 300 <- !drive.
+!go                                          <- .print("too old to go by").

+!drive           <- argo.act(drive, [timeout(800)]); .print("driving").
-!drive[error(E)] <- .print("not driving: ", E).
