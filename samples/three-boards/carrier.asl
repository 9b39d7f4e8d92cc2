// Fetches a can with three boards: wheels, sensors and an arm.
{ include("wheels.asl", wheels) }

!fetch.

+!fetch : boards(Ports) <-
    argo.ports(Ports);
    argo.limit(20);
    argo.percepts(open);
    .wait(sensors::dist(front, _) & arm::hand(open), 5000);
    !wheels::drive(forward).

// in front of the can
+sensors::dist(front, Cm) : Cm <= 10 & wheels::moving(forward) <-
    !wheels::halt;
    .wait(wheels::moving(no), 5000);
    argo.skew(Ms);
    .print("the can is ", Cm, " cm ahead; the readings are at most ", Ms, " ms apart");
    argo.act(grip);
    .wait(arm::hand(full), 5000);
    .print("the arm has the can");
    !wheels::drive(backward).

// back at the start
+wheels::way(0) : wheels::moving(backward) <-
    !wheels::halt;
    .wait(wheels::moving(no), 5000);
    argo.act(arm::release);
    .wait(arm::hand(open), 5000);
    .print("the can is at the start");
    .stopMAS.

// without percepts the agent does not drive
+stale(_) : not wheels::moving(no) <- !wheels::halt.

-!fetch[error_msg(Why)] <- .print(Why); .stopMAS(0, 1).
