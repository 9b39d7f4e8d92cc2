// Turns the LED of its board on while something is near the front.

// The port of the board. The port below is a recording, which needs no board. For a real board, write its port: board(ttyACM0). "java -jar
// lib/argo.jar ports" lists the available ports.
board("replay:recordings/drive.rec").

!start.

+!start : board(Port) <-
    argo.port(Port);
    argo.limit(100);
    argo.change_filter(frontOnly);
    argo.percepts(open).

-!start[error_msg(Why)] <- .print(Why); .wait(2000); !start.

+dist(front, Cm) : Cm < 40 & not led(on) <-
    -+led(on);
    argo.act(ledOn);
    .print("something is ", Cm, " cm in front of me").

+dist(front, Cm) : Cm >= 40 & led(on) <-
    -+led(off);
    argo.act(ledOff);
    .print("the way is free").

// Nothing is in sight.
-dist(front, _) : led(on) & not dist(front, _) <-
    -+led(off);
    argo.act(ledOff).

// ARGO reopens the port when its board is back.
+port(Port, off) <- .print("there is no board at ", Port).
