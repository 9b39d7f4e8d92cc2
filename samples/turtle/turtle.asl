// Drives at a wall, stops before it, and goes home.

!start.

+!start : board(Port) <-
    argo.port(Port);
    argo.limit(20);
    argo.percepts(open);
    argo.act(drive(0.8));
    .print("drives").
-!start[error_msg(Why)] <- .print(Why); .stopMAS(0, 1).

+dist(f, Cm) : Cm < 40 & not home(_) <-
    +home(is_next);
    argo.act(stop);
    .print("stopped ", Cm, " cm before the wall");
    !home.

+!home <- argo.act(dock); .print("docked"); .stopMAS. // the action's result has come
-!home[error(E), error_msg(Why)] <- .print(E, ": ", Why); .stopMAS(0, 1).
