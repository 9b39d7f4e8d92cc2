/* Controls a greenhouse. Waters by day if the soil is dry, opens the vent if it is hot, and obeys the operator.

   Its initial beliefs are in the .mas2j:
     board(Port)    the port of the greenhouse
     minute(Ms)     the length of a minute, less than 60000 for accelerated time */

/* Each limit has two thresholds, so that a fluctuating value does not switch a device each time. */

dark :- light(Level) & Level < 100.

wanted(Device, State) :- ordered(Device, State).
wanted(pump, on)      :- not ordered(pump, _) & not dark & soil(Percent) & Percent < 30.
wanted(pump, off)     :- not ordered(pump, _) & soil(Percent) & (dark | Percent > 45).
wanted(vent, open)    :- not ordered(vent, _) & not dark & temp(Celsius) & Celsius > 27.
wanted(vent, closed)  :- not ordered(vent, _) & temp(Celsius) & (dark | Celsius < 23).

/* The minutes for which a switched device stays unchanged. */

rest(pump, 5).
rest(vent, 15).

!start.

+!start : board(Port) & minute(Ms) <-
    argo.port(Port);
    argo.change_filter(slow);
    argo.limit(Ms);
    argo.percepts(open).

+soil(_)  <- !tend(pump).
+temp(_)  <- !tend(vent).
+light(_) <- !tend(pump); !tend(vent).

@tend[atomic] // no other event may come between the question and the answer
+!tend(Device) : wanted(Device, State) & state(Device, Other) & State \== Other & not rests(Device) <-
    +rests(Device);
    !!switch(Device, State).
+!tend(_).

+!switch(Device, State) <-
    argo.act(set(Device, State));
    .print(Device, " ", State);
    !rest(Device).
-!switch(Device, _)[error_msg(Why)] <- .print(Device, ": ", Why); !rest(Device).

+!rest(Device) : rest(Device, Minutes) & minute(Ms) <-
    .wait(Minutes * Ms);
    -rests(Device);
    !tend(Device).

/* Orders of the operator, such as order(vent, closed) and order(vent, automatic) */

+!order(Device, automatic)[source(operator)] <- -ordered(Device, _); !tend(Device).
+!order(Device, State)[source(operator)] <-
    -ordered(Device, _);
    +ordered(Device, State);
    !tend(Device).
-!order(Device, State)[source(Other)] <- .print(Other, " may not order ", Device, " ", State).

/* Without percepts, the gardener stops watering. Without commands, the board stops, too. */

+stale(_) : state(pump, on) <- argo.act(set(pump, off)).
