// Calls ping until it answers. Then sends all messages back.
!call.

+!call : not met <- .send(ping, achieve, start); .wait(300); !call.
+!call.
-!call <- .wait(300); !call.

+!back[source(S)] : met <- .send(S, achieve, here).
+!back[source(S)] <- +met; .send(S, achieve, here).
