// Sees distances and has the wheels. It drives towards the wall when the others see too, and stops at the limit.
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

// only what concerns the pilot reaches it: no temperature, but a robot that is too hot
+too_hot(Degrees)[source(engineer)] <-
    .print(Degrees, " degrees: stopped");
    argo.act(stop).
