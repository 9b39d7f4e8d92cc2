/* Senses, reasons and acts, with all sensors or with those of one kind.
   The experiment on delegation adds plans for each kind of percept, and these beliefs:
     boards(Ports)   its boards, as for argo.ports
     interval(Ms)    the sensing interval */

!open.

+!open : boards(Ports) & interval(Ms) <-
    argo.ports(Ports);
    argo.limit(Ms);
    argo.percepts(open).

+dist(_, Cm) : Cm < 40 <- argo.act(stop(Cm)).
