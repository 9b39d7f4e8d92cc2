// Senses and acts. Sends each percept to the agent that reasons about it.

reasons_on(dist, pilot).
reasons_on(light, lamplighter).

!open.

+!open : board(Port) <-
    argo.port(Port);
    argo.limit(20);
    argo.percepts(open);
    .broadcast(tell, body_is_ready).

+dist(f, Cm)    <- !pass_on(dist, tell, dist(Cm)).
-dist(f, Cm)    <- !pass_on(dist, untell, dist(Cm)).
+light(f, Level) <- !pass_on(light, tell, light(Level)).
-light(f, Level) <- !pass_on(light, untell, light(Level)).

+!pass_on(Sense, Performative, Percept) : reasons_on(Sense, Agent) <- .send(Agent, Performative, Percept).

+!do(Command)[source(Agent)] <-
    argo.act(Command);
    .send(Agent, tell, done(Command)).

-!open[error_msg(Why)] <- .print(Why); .stopMAS(0, 1).
