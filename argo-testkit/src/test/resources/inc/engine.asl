+!drive : driving <- true.
+!drive <- +driving; argo.act(front).
+!halt  <- -driving; argo.act(stop).
