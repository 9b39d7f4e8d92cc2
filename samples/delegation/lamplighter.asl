// Switches the body's lamp on while the light in front is bright.

+light(Level)[source(Body)] : Level > 100  & not lit <- +lit; .send(Body, achieve, do(ledLightOn)).
+light(Level)[source(Body)] : Level <= 100 & lit     <- -lit; .send(Body, achieve, do(ledLightOff)).
