// The eyes of @NAME@: a distance sensor HC-SR04 (Trig to pin 7, Echo to pin 8) and a light sensor at A1.
//
//   percepts  dist(front,Cm) while an object is in sight, light(left,Value)

#include <Javino.h>

const uint8_t TRIGGER = 7;
const uint8_t ECHO_PIN = 8;
const unsigned long ECHO_LIMIT_US = 25000;
const unsigned long US_PER_CM = 58;  // to the object and back

Javino javino;

// The distance to the object in front, in cm. 0 means no object within 4 m, or no sensor.
unsigned long centimetres() {
  digitalWrite(TRIGGER, HIGH);
  delayMicroseconds(10);
  digitalWrite(TRIGGER, LOW);
  return (pulseIn(ECHO_PIN, HIGH, ECHO_LIMIT_US) + US_PER_CM / 2) / US_PER_CM;
}

void look() {
  javino.describe(F("dist(front, cm 1..431)"));
  javino.describe(F("light(left, 0..1023)"));
  unsigned long cm = centimetres();
  if (cm > 0)
    javino.percept("dist", "front", cm);
  javino.percept("light", "left", analogRead(A1));
}

void setup() {
  pinMode(TRIGGER, OUTPUT);
  pinMode(ECHO_PIN, INPUT_PULLUP);  // without a sensor, the open pin would show false objects
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  javino.run();
}
