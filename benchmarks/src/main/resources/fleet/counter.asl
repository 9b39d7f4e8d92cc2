// Counts ten times per second.
count(0).

!count.

+!count : count(N) <- -+count(N + 1); benchmarks.fleet.counted(N + 1); .wait(100); !count.
