// Shares the places that must be watched among the scouts that it hears of, and anew when one falls silent or joins.

place(north). place(east). place(south). place(west).
patience(10). // rounds of 200 ms without a report until a scout counts as lost: several of its reports

load(Scout,N) :- silent(Scout,_) & .count(watches(Scout,_),N).

!oversee.

@hear[atomic]
+!hear[source(Scout)] : silent(Scout,Rounds) <-
    -silent(Scout,Rounds);
    +silent(Scout,0).

// a scout that comes back after it counted as lost must not go on with places that others watch by now
+!hear[source(Scout)] <-
    +silent(Scout,0);
    .print(Scout, " is there");
    .send(Scout, achieve, stand_by).

+!visited(Place)[source(Scout)] <- .print(Scout, " has visited ", Place).

+!oversee <-
    for (silent(Scout,_)) { !count(Scout) };
    for (place(Place) & not watches(_,Place)) { !assign(Place) };
    !balance;
    .wait(200);
    !oversee.

@count[atomic]
+!count(Scout) : silent(Scout,Rounds) & patience(Most) & Rounds < Most <-
    -silent(Scout,Rounds);
    +silent(Scout,Rounds+1).
+!count(Scout) <-
    .abolish(silent(Scout,_));
    .abolish(watches(Scout,_));
    .print(Scout, " is lost").

+!assign(Place) : .findall(l(N,Scout), load(Scout,N), Loads) & .min(Loads, l(_,Scout)) <- !give(Scout,Place).
+!assign(_). // nobody is there yet

+!balance : load(Idle,Few) & load(Busy,Many) & Many > Few + 1 & watches(Busy,Place) <-
    -watches(Busy,Place);
    .send(Busy, achieve, leave(Place));
    !give(Idle,Place).
+!balance.

+!give(Scout,Place) <-
    +watches(Scout,Place);
    .print(Scout, " watches ", Place);
    .send(Scout, achieve, watch(Place)).
