// A module for a board with wheels: its percepts and actions are in the namespace in which this file is included.

+!drive(Direction) : not moving(Direction) <- argo.act(Direction).
+!drive(_).

+!halt <- argo.act(halt).
