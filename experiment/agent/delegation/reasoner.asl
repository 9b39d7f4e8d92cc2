/* A common Jason agent: reasons on what a body tells it, and asks that body to act. The experiment on delegation gives it plans for its
   kind of percept. */

+dist(_, Cm)[source(Body)] : Cm < 40 <- .send(Body, achieve, do(stop(Cm))).
