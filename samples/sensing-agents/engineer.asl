// Perceives temperatures. Tells the pilot that it can sense, and each temperature above the limit.
{ include("senses.asl") }

+temp(f, _) : not told <- +told; .send(pilot, tell, sees(engineer)).
+temp(_, Degrees) : limit(Limit) & Degrees > Limit & not hot <- +hot; .send(pilot, tell, too_hot(Degrees)).
