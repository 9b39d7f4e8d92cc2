// The lamp of @NAME@: an LED.
//
//   actions   ledOn, ledOff
//   percepts  led(on) or led(off)

#include <Javino.h>

Javino javino;

void ledOn() {
  digitalWrite(LED_BUILTIN, HIGH);
}

void ledOff() {
  digitalWrite(LED_BUILTIN, LOW);
}

void look() {
  javino.describe(F("led(on|off)"));
  javino.percept("led", digitalRead(LED_BUILTIN) ? "on" : "off");
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
