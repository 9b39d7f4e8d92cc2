// The smallest agent: the LED of a board blinks.

!start.

+!start : board(Port) <- argo.port(Port); !on.
-!start <- .stopMAS(0, 1). // there is no such board, or it has gone: the log says why

+!on  <- argo.act(ledOn);  .wait(500); !off.
+!off <- argo.act(ledOff); .wait(500); !on.
