// Sees light and has a lamp, which burns while it is bright in front of it. Tells the pilot only that it sees.
{ include("senses.asl") }

+light(f, _) : not told <- +told; .send(pilot, tell, sees(lamplighter)).
+light(f, Level) : Level > 100  & not lit <- +lit; argo.act(ledLightOn).
+light(f, Level) : Level <= 100 & lit     <- -lit; argo.act(ledLightOff).
