/* Drives towards a wall and stops in front of it, after the case study of C. E. Pantoja et al., EMAS 2016.

   Its initial beliefs are in the .mas2j:
     board(Port, Options)   the port of the robot, or
     boards(Ports)          the ports of its boards, as for argo.ports, with the wheels first
     value(Cm)              the front distance at which it stops
     interval(Ms)           the sensing interval
     view(Filter)           none, or a filter of filters/ */

/* Goals */

!config.

/* Plans: driving */

+!config : interval(Ms) & view(Filter) <-
    !open;
    .limit(Ms);
    .filter(Filter);
    .percepts(open);
    !start.

+!open : board(Port, Options) <- .port(Port, Options).
+!open : boards(Ports) <- .ports(Ports). // argo: others may send boards/1

+!start <-
    .wait(dist(f, _)); // does not drive before the first distance
    .act(front);
    +status(front);
    !moving.

+!moving : port(_, timeout) & status(front) <- // without percepts the agent does not drive
    .act(stop);
    .wait(not port(_, timeout));
    !moving.

+!moving : dist(f, Cm) & value(Limit) & Cm > Limit & status(front) <-
    .act(front);
    !moving.

+!moving : dist(f, Cm) & value(Limit) & Cm <= Limit & status(front) <-
    .act(stop);
    -+status(stopped);
    .print("stopped: the front sensor says ", Cm, " cm").

-!moving[error(port_gone), error_msg(Why)] <- +trouble(Why).
-!moving : port(_, off) <- +trouble("the board has gone").
-!moving : status(front) <- !!moving. // no percepts yet

/* Plans: lamps; a level is 0 to 1023, and higher if it is darker */

+light(_, Level) : Level > 100  <- .act(ledLightOn).
+light(_, Level) : Level <= 100 <- .act(ledLightOff).
+temp(_, Degrees) : Degrees > 25  <- .act(ledTempOff).
+temp(_, Degrees) : Degrees <= 25 <- .act(ledTempOn).

/* Plans: failures */

-!config[error_msg(Why)] <- +trouble(Why).
-!start[error(act_refused), error_msg(Why)] <- +trouble(Why).
-!start[error_msg(Why)] <- +status(front); +trouble(Why). // the robot may have got the command
+trouble(Why) <- .print(Why).

+!halt <- // called by the program that runs the agent
    .drop_desire(config);
    .drop_desire(moving);
    .act(stop);
    -+status(stopped).
