// The board of @NAME@: an LED, and a distance sensor that gives its voltage to A0.
//
//   actions   ledOn, ledOff
//   percepts  dist(front,Cm), light(left,Value)

#include <Javino.h>

Javino javino;

void ledOn() {
  digitalWrite(LED_BUILTIN, HIGH);
}

void ledOff() {
  digitalWrite(LED_BUILTIN, LOW);
}

// A sonar of the MaxSonar kind: Vcc/512 an inch. For another sensor, another formula.
int centimetres() {
  return analogRead(A0) / 2 * 2.54;
}

void look() {
  javino.percept("dist", "front", centimetres());
  javino.percept("light", "left", analogRead(A1));
}

void setup() {
  pinMode(LED_BUILTIN, OUTPUT);
  javino.act["ledOn"] = ledOn;
  javino.act["ledOff"] = ledOff;
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  javino.run();
}
