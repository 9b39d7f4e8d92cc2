// A robot of the fleet. Reports to the coordinator, and visits its assigned places in turn.

trips(0).

!start.

+!start : board(Board) <-
    argo.port(Board);
    argo.limit(100);
    argo.percepts(open);
    !!report;
    !!patrol.

+!report <-
    .send(coordinator, achieve, hear);
    .wait(300);
    !report.
// the coordinator is unreachable, or moves to another computer
-!report <-
    .wait(300);
    !report.

+!watch(Place)[source(coordinator)] <- +place(Place).
+!leave(Place)[source(coordinator)] <- .abolish(place(Place)).
+!stand_by[source(coordinator)] <- .abolish(place(_)).

+!patrol : place(_) <-
    for (place(Place)) { !visit(Place) };
    !patrol.
+!patrol <-
    .wait(100);
    !patrol.

// The trip number makes each .wait formula unique. The timer of a .wait continues after the wait, and would end a later equal one.
+!visit(Place) : trips(N) <-
    Trip = N + 1;
    -+trips(Trip);
    argo.act(goto(Place));
    .wait(at(Place) & trips(Trip), 5000);
    !tell(visited(Place)).
-!visit(Place)[error(Error)] <-
    .print("did not reach ", Place, ": ", Error);
    .wait(500).

+!tell(News) <- .send(coordinator, achieve, News).
-!tell(_)[error(unreachable)]. // nobody waits for the news
