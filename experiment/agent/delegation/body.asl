/* Senses and acts. Sends each percept to the agent that reasons about it, like the body of the sample delegation.
   The experiment on delegation adds these beliefs:
     boards(Ports)            its boards, as for argo.ports
     interval(Ms)             the sensing interval
     reasons_on(Kind, Agent)  the agent that reasons about percepts of this kind */

!open.

+!open : boards(Ports) & interval(Ms) <-
    argo.ports(Ports);
    argo.limit(Ms);
    argo.percepts(open).

+dist(S, N)  : reasons_on(dist, A)  <- .send(A, tell, dist(S, N)).
-dist(S, N)  : reasons_on(dist, A)  <- .send(A, untell, dist(S, N)).
+light(S, N) : reasons_on(light, A) <- .send(A, tell, light(S, N)).
-light(S, N) : reasons_on(light, A) <- .send(A, untell, light(S, N)).
+temp(S, N)  : reasons_on(temp, A)  <- .send(A, tell, temp(S, N)).
-temp(S, N)  : reasons_on(temp, A)  <- .send(A, untell, temp(S, N)).

+!do(Command) <- argo.act(Command).
