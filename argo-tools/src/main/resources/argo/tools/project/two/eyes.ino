// The eyes of @NAME@: a distance sensor that gives its voltage to A0, and a light sensor at A1.
//
//   percepts  dist(front,Cm), light(left,Value)

#include <Javino.h>

Javino javino;

// A sonar of the MaxSonar kind: Vcc/512 an inch. For another sensor, another formula.
int centimetres() {
  return analogRead(A0) / 2 * 2.54;
}

void look() {
  javino.percept("dist", "front", centimetres());
  javino.percept("light", "left", analogRead(A1));
}

void setup() {
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  javino.run();
}
