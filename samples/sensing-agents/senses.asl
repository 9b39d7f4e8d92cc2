// What the three agents have in common: each perceives the board that it believes in.

!open.

+!open : board(Port) <-
    argo.port(Port);
    argo.limit(20);
    argo.percepts(open).

-!open[error_msg(Why)] <- .print(Why); .stopMAS(0, 1).
