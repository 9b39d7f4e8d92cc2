// Works with two boards alternately. Both boards stay open. The agent perceives the current board and sends it commands.

!work.

+!work <-
    argo.limit(20);
    argo.percepts(open);
    !switch(left, on);
    !switch(right, on);
    !switch(left, off);
    !switch(right, off);
    .stopMAS.

+!switch(Side, on)  <- !use(Side); argo.act(ledOn);  !see(Side, on).
+!switch(Side, off) <- !use(Side); argo.act(ledOff); !see(Side, off).

+!use(Side) : board(Side, Port) <- argo.port(Port).

+!see(Side, State) <-
    .wait(led(Side, State), 5000); // until the board reports it
    .print("the ", Side, " LED is ", State).

-!work[error_msg(Why)] <- .print(Why); .stopMAS(0, 1).
