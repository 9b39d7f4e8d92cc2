// The robot of the stop measurements, with the original version 1 library. This sketch has the percepts, actions and pins of the sketch
// Stops. Compiled with BAUD and LOOP_MS.
#include "field.h"

const uint8_t DRIVES = 8;
const uint8_t ACTED = 9;
const uint8_t LOOKED = 10;
const uint8_t STARTED = 11;

uint8_t reading = 0;

void toggle(uint8_t pin) {
  digitalWrite(pin, !digitalRead(pin));
}

void answer() {
  const char sides[] = "fbrl";
  char text[256];
  uint8_t size = 0;
  toggle(LOOKED);
  reading = (reading + 1) % 90;
  for (uint8_t side = 0; side < 4; side++) {
    int distance = side == 0 ? analogRead(A0) * 5000L / 1023 : 300 + reading;
    int light = 60 + 20 * side + reading;
    int temperature = 10 + (reading + side) % 30;
    size += snprintf(text + size, sizeof text - size, "dist(%c,%d);light(%c,%d);temp(%c,%d);", sides[side], distance,
                     sides[side], light, sides[side], temperature);
  }
  sendMessage(text);
}

void act() {
  toggle(ACTED);
  if (!strcmp(message, "front"))
    digitalWrite(DRIVES, HIGH);
  else if (!strcmp(message, "stop"))
    digitalWrite(DRIVES, LOW);
}

void setup() {
  for (uint8_t pin = DRIVES; pin <= STARTED; pin++)
    pinMode(pin, OUTPUT);
  toggle(STARTED);
  Serial.begin(BAUD);
}

void loop() {
  receive(answer, act);
  delay(LOOP_MS);
}
