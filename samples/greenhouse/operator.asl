// Closes the vent for a storm at noon, and later returns it to automatic control. Ends the sample in the evening.

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
