// Looks at the world without a filter, then through two that it asks for by name.

!watch.

+!watch : board(Port) <-
    argo.port(Port);
    argo.limit(20);
    argo.percepts(open);
    .wait(dist(_, _), 5000);
    !report("no filter");
    argo.change_filter(frontOnly);
    .wait(not dist(b, _), 5000);
    !report(frontOnly);
    argo.explain(dist(b, 50), WhyNotBack);
    .print(WhyNotBack);
    argo.change_filter(nearFront);
    .wait(not dist(f, _), 5000); // the wall is two metres away
    !report(nearFront);
    argo.explain(dist(f, 120), WhyNotFront);
    .print(WhyNotFront);
    .stopMAS.

+!report(Filter) <-
    .count(dist(_, _), Distances);
    .count(light(_, _), Lights);
    .print("through ", Filter, ": ", Distances, " distances, ", Lights, " lights").

-!watch[error_msg(Why)] <- .print(Why); .stopMAS(0, 1).
