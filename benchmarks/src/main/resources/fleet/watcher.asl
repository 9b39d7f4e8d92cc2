// Waits until it knows all agents.
!watch.

+!watch : .all_names(L) & .length(L, 1000) <- benchmarks.fleet.known(L).
+!watch <- .wait(500); !watch.
