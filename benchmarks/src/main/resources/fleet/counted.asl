// Counts the agents of its own process.
!count.

+!count <- .all_names(L); benchmarks.fleet.known(L).
