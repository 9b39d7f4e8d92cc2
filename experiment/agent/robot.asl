/* Drives towards a wall and stops in front of it. This is the agent of the case study in C. E. Pantoja et al., EMAS 2016, Figure 7, with
   four differences:
     - Port, interval, limit and filter are beliefs.
     - It adds the belief status(stopped) when it has stopped.
     - It switches the lamp off for light of at most 100. Both published plans (lines 30 to 34) switch it on.
     - The plans for failures, +trouble and +!halt are new.

   Its initial beliefs are in the .mas2j, or come from the experiment:
     board(Port, Options)   the port of the robot
     value(Cm)              the front distance at which it stops
     interval(Ms)           the sensing interval
     view(Filter)           none, or a filter of filters/ or ReflexFilters.kt */

/* Goals */

!config.

/* Plans: driving */

+!config : board(Port, Options) & interval(Ms) & view(Filter) <-
    .port(Port, Options);
    .limit(Ms);
    .filter(Filter);
    .percepts(open);
    !start.

+!start : true <-
    .act(front);
    +status(front);
    !moving.

+!moving : dist(f, X) & value(J) & X > J & status(front) <-
    .act(front);
    !moving.

+!moving : dist(f, X) & value(J) & X <= J & status(front) <-
    .act(stop);
    -+status(stopped).

-!moving[error(port_gone), error_msg(Why)] <- +trouble(Why). // the published agent would try again for ever
-!moving <- !!moving.

/* Plans: lamps */

+light(X, Y) : Y > 100  <- .act(ledLightOn).
+light(X, Y) : Y <= 100 <- .act(ledLightOff).
+temp(X, Y) : Y > 25  <- .act(ledTempOff).
+temp(X, Y) : Y <= 25 <- .act(ledTempOn).

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
