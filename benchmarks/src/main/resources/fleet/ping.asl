// Sends a message to pong on another computer, and the next one when the answer has come.
+!start : not begun <- +begun; !!lap.
+!start.

+!lap  <- benchmarks.fleet.left; .send(pong, achieve, back).
+!here <- benchmarks.fleet.came; !!lap.
