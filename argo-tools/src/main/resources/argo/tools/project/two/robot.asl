// Turns the LED of one board on while the other board sees something near.

// The boards, each with its port and the namespace of its percepts. The ports below are recordings, which need no boards. For real boards,
// write their ports: port(ttyACM0,[as(eyes)]). "java -jar lib/argo.jar ports" lists the available ports.
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

// Nothing is in sight.
-eyes::dist(front, _) : led(on) & not eyes::dist(front, _) <-
    -+led(off);
    argo.act(lamp::ledOff).

// ARGO reopens the port when its board is back.
+port(Port, off) <- .print("there is no board at ", Port).
