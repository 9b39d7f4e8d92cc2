// A module for a board with wheels. The module's percepts and actions are in the namespace of the include.

+!drive(Direction) : not moving(Direction) <- argo.act(Direction).
+!drive(_).

+!halt <- argo.act(halt).
