// Perceives light, and switches its lamp on while the light in front is bright. Tells the pilot only that it can sense.
{ include("senses.asl") }

+light(f, _) : not told <- +told; .send(pilot, tell, sees(lamplighter)).
+light(f, Level) : Level > 100  & not lit <- +lit; argo.act(ledLightOn).
+light(f, Level) : Level <= 100 & lit     <- -lit; argo.act(ledLightOff).
