// The common part of the three agents: each perceives the board in its beliefs.

!open.

+!open : board(Port) <-
    argo.port(Port);
    argo.limit(20);
    argo.percepts(open).

-!open[error_msg(Why)] <- .print(Why); .stopMAS(0, 1).
