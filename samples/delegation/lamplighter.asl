// Has the body's lamp lit while it is bright in front of it.

+light(Level)[source(Body)] : Level > 100  & not lit <- +lit; .send(Body, achieve, do(ledLightOn)).
+light(Level)[source(Body)] : Level <= 100 & lit     <- -lit; .send(Body, achieve, do(ledLightOff)).
