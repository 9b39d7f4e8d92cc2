/* A common Jason agent. Reasons about percepts from a body, and asks that body to act. The experiment on delegation adds plans for its
   kind of percept. */

+dist(_, Cm)[source(Body)] : Cm < 40 <- .send(Body, achieve, do(stop(Cm))).
