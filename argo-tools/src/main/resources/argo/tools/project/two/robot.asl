// Turns the LED of one board on while something is near in front of the other.

// The boards: their ports, and the namespaces of what they say. These are recordings, so that everything runs without a board; for real
// ones write their names: port(ttyACM0,[as(eyes)]). "java -jar lib/argo.jar ports" lists the ports that there are.
boards([port("replay:recordings/drive.rec",[as(eyes)]), port("replay:recordings/lamp.rec",[as(lamp)])]).

!start.

+!start : boards(Ports) <-
    argo.ports(Ports);
    argo.limit(100);
    argo.change_filter(frontOnly);
    argo.percepts(open).

-!start[error_msg(Why)] <- .print(Why); .wait(2000); !start.

+eyes::dist(front, Cm) : Cm < 40 & not led(on) <-
    -+led(on);
    argo.act(lamp::ledOn);
    .print("something is ", Cm, " cm in front of me").

+eyes::dist(front, Cm) : Cm >= 40 & led(on) <-
    -+led(off);
    argo.act(lamp::ledOff);
    .print("the way is free").

// Nothing is in sight any more.
-eyes::dist(front, _) : led(on) & not eyes::dist(front, _) <-
    -+led(off);
    argo.act(lamp::ledOff).

// ARGO reopens a port whose board is back.
+port(Port, off) <- .print("there is no board at ", Port).
