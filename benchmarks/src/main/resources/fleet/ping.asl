// Sends a message to pong on another computer. Sends the next one after the answer.
+!start : not begun <- +begun; !!lap.
+!start.

+!lap  <- benchmarks.fleet.left; .send(pong, achieve, back).
+!here <- benchmarks.fleet.came; !!lap.
