/* Senses, reasons and acts: one agent with all sensors, or an agent with those of one kind. The experiment on delegation gives it
     boards(Ports)   its boards, as for argo.ports
     interval(Ms)    the sensing interval
   and plans for each kind of percept. */

!open.

+!open : boards(Ports) & interval(Ms) <-
    argo.ports(Ports);
    argo.limit(Ms);
    argo.percepts(open).

+dist(_, Cm) : Cm < 40 <- argo.act(stop(Cm)).
