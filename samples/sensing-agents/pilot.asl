// Perceives distances, and has the wheels. Drives towards the wall when the other agents can sense, and stops at the limit.
{ include("senses.asl") }

!drive.

+!drive <-
    .wait(dist(f, _) & sees(lamplighter) & sees(engineer), 5000);
    argo.act(front).

-!drive[error_msg(Why)] <- .print("does not drive: ", Why); .stopMAS(0, 1).

+dist(f, Cm) : limit(Limit) & Cm <= Limit & not stopping <-
    +stopping;
    argo.act(stop);
    .print("the wall is ", Cm, " cm away: stopped");
    .stopMAS.

// the pilot gets no temperatures, but only the news that the robot is too hot
+too_hot(Degrees)[source(engineer)] <-
    .print(Degrees, " degrees: stopped");
    argo.act(stop).
