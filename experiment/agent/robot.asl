/* Drives towards a wall and stops in front of it: the agent of the case study in C. E. Pantoja et al., EMAS 2016, Figure 7, with these
   differences. Port, interval, limit and filter are beliefs. It says when it has stopped. For light of at most 100 it switches the lamp off,
   where both published plans (lines 30 to 34) switch it on. The plans for failures, +trouble and +!halt are added.

   Its initial beliefs are in the .mas2j, or come from the experiment:
     board(Port, Options)   where the robot is
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

-!moving[error(port_gone), error_msg(Why)] <- +trouble(Why). // the published agent would try for ever
-!moving <- !!moving.

/* Plans: lamps */

+light(X, Y) : Y > 100  <- .act(ledLightOn).
+light(X, Y) : Y <= 100 <- .act(ledLightOff).
+temp(X, Y) : Y > 25  <- .act(ledTempOff).
+temp(X, Y) : Y <= 25 <- .act(ledTempOn).

/* Plans: when something goes wrong */

-!config[error_msg(Why)] <- +trouble(Why).
+trouble(Why) <- .print(Why).

+!halt <- // the program that runs the agent gives it up
    .drop_desire(config);
    .drop_desire(moving);
    .act(stop);
    -+status(stopped).
