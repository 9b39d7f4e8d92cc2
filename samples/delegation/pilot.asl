// Drives the body towards the wall, and stops it at the limit. Knows distances and commands, but no port.

+body_is_ready[source(Body)] <- .send(Body, achieve, do(front)).

+dist(Cm)[source(Body)] : limit(Limit) & Cm <= Limit & not stopping <-
    +stopping;
    .print("the wall is ", Cm, " cm away: stop");
    .send(Body, achieve, do(stop)).

+done(stop) <-
    .wait(500); // the board gets time to act on the command
    .stopMAS.
