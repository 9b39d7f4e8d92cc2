// A module for a board with wheels: what it says and does is in the namespace that this file is included in.

+!drive(Direction) : not moving(Direction) <- argo.act(Direction).
+!drive(_).

+!halt <- argo.act(halt).
