board("/tmp/ttyUNO").

!start.

+!start : board(Port) <-
    argo.port(Port);
    argo.limit(100);
    argo.percepts(open);
    !drive.

+!drive <- argo.act(drive); .print("driving").

+dist(front, Cm) : Cm < 30 & not turning <-
    +turning;
    .print("a wall, ", Cm, " cm");
    argo.act(stop);
    argo.act(turn(left)).

+dist(front, Cm) : Cm > 50 & turning <-
    -turning;
    !drive.

+port(Port, off) <- .print("no line to ", Port).

-!start[error_msg(Why)] <- .print(Why).
