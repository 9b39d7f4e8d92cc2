// The smallest agent: it makes the LED of a board blink.

!start.

+!start : board(Port) <- argo.port(Port); !on.
-!start <- .stopMAS(0, 1). // there is no board; the log tells the reason

+!on  <- argo.act(ledOn);  .wait(500); !off.
+!off <- argo.act(ledOff); .wait(500); !on.
