// Distributes the places among the scouts, and does so again when a scout appears or disappears. If its computer fails, it continues on
// another one.

place(north). place(east). place(south). place(west).

load(Scout,N) :- known(Scout) & .count(watches(Scout,_),N).

!oversee.

+!hear[source(Scout)] : known(Scout).
// a scout that returns must give up its places, which others watch by now
+!hear[source(Scout)] <-
    .print(Scout, " is there");
    .send(Scout, achieve, stand_by);
    +known(Scout).

// The coordinator continues on another computer, with beliefs that are a second or two old. The coordinator repeats its orders according to
// these beliefs.
+agent(coordinator,_) <- for (known(Scout)) { !remind(Scout) }.

+!remind(Scout) <-
    .send(Scout, achieve, stand_by);
    for (watches(Scout,Place)) { !give(Scout,Place) }.
-!remind(_)[error(unreachable)].

+!visited(Place)[source(Scout)] <- .print(Scout, " has visited ", Place).

+!oversee <-
    for (known(Scout) & not agent(Scout,_)) { !lose(Scout) };
    for (place(Place) & not watches(_,Place)) { !assign(Place) };
    !balance;
    .wait(200);
    !oversee.

+!lose(Scout) <-
    -known(Scout);
    .abolish(watches(Scout,_));
    .print(Scout, " is lost").

+!assign(Place) : .findall(l(N,Scout), load(Scout,N), Loads) & .min(Loads, l(_,Scout)) <- !give(Scout,Place).
+!assign(_). // no scout has appeared yet

+!balance : load(Idle,Few) & load(Busy,Many) & Many > Few + 1 & watches(Busy,Place) <-
    !take(Busy,Place);
    !give(Idle,Place).
+!balance.

+!take(Scout,Place) <-
    .abolish(watches(Scout,Place));
    .send(Scout, achieve, leave(Place)).
-!take(_,_)[error(unreachable)]. // the scout will get stand_by when it returns

+!give(Scout,Place) <-
    +watches(Scout,Place);
    .print(Scout, " watches ", Place);
    .send(Scout, achieve, watch(Place)).
-!give(Scout,Place)[error(unreachable)] <- .abolish(watches(Scout,Place)).
