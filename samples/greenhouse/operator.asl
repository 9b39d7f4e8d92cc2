// A person who has the vent closed for a storm at noon, and gives it back. In the evening the sample ends.

!day.

+!day : minute(Ms) <-
    .wait(420 * Ms);
    .print("a storm: close the vent");
    .send(gardener, achieve, order(vent, closed));
    .wait(120 * Ms);
    .print("the storm is over");
    .send(gardener, achieve, order(vent, automatic));
    .wait(720 * Ms);
    .stopMAS.
