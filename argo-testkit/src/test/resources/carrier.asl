!start.

+!start <- argo.ports([port(ttyACM0,[as(wheels)]), port(ttyACM1,[as(sensors)])]); argo.limit(50); argo.percepts(open).

+sensors::dist(front,Cm) : Cm < 15 <- argo.act(wheels::stop).
+stale(ttyACM1) <- argo.act(wheels::stop).
