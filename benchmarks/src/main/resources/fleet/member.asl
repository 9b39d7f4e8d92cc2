// Is there.
