// The distance from an HC-SR04. An interrupt times the echo's pulse, so loop() does not wait. pulseIn() would block loop() during the
// pulse: for 38 ms if nothing is in sight.
//
//   wiring    Trig to pin 7; Echo to pin 2, which has an interrupt (on an Uno 2 and 3 do); VCC to 5 V; GND. For a board of 3.3 V, two
//             resistors divide Echo's 5 V.
//   actions   none
//   percepts  dist(Cm); clear if nothing is in sight; silent(sonar) if no sensor answers
//   agent     !start.
//             +!start <- argo.port(ttyACM0); argo.percepts(open).
//             +dist(Cm) : Cm < 40 <- .print("something is ", Cm, " cm in front of me").
//             +silent(sonar) <- .print("is Echo connected to pin 2?").

#include <Javino.h>

// On an ESP32 and an ESP8266, functions that an interrupt calls must be in RAM.
#ifndef IRAM_ATTR
#define IRAM_ATTR
#endif

const uint8_t TRIGGER = 7;
const uint8_t ECHO_PIN = 2;
const unsigned long PERIOD_MS = 60;  // the sound of a measurement fades before the next one
const unsigned long US_PER_METRE = 5830;  // sound travels to the object and back, in air of 20 degrees
const unsigned long MAX_CM = 400;

Javino javino;

// Written by the interrupt.
volatile unsigned long rose = 0;
volatile unsigned long lasted = 0;
volatile bool isHigh = false;

enum Sight { UNKNOWN, SILENT, CLEAR, SEEN };
Sight sight = UNKNOWN;
unsigned long cm = 0;
unsigned long triggered = 0;
bool isMeasuring = false;

void IRAM_ATTR echoChanged() {
  isHigh = digitalRead(ECHO_PIN) == HIGH;
  if (isHigh)
    rose = micros();
  else
    lasted = micros() - rose;
}

// Takes the result of the last measurement.
void judge() {
  noInterrupts();
  bool goesOn = isHigh;
  unsigned long us = lasted;
  lasted = 0;
  interrupts();
  cm = (us * 100 + US_PER_METRE / 2) / US_PER_METRE;
  if (goesOn || cm > MAX_CM)  // without an object, some sensors send pulses of 200 ms
    sight = CLEAR;
  else
    sight = us ? SEEN : SILENT;
}

void measure() {
  if (isMeasuring && millis() - triggered < PERIOD_MS)
    return;
  if (isMeasuring)
    judge();
  isMeasuring = true;
  triggered = millis();
  digitalWrite(TRIGGER, HIGH);
  delayMicroseconds(10);
  digitalWrite(TRIGGER, LOW);
}

void look() {
  javino.describe(F("dist(cm 0..400)"));
  javino.describe(F("clear"));
  javino.describe(F("silent(sonar)"));
  if (sight == SEEN)
    javino.percept("dist", cm);
  else if (sight == CLEAR)
    javino.percept("clear");
  else if (sight == SILENT)
    javino.percept("silent", "sonar");
}

void setup() {
  pinMode(TRIGGER, OUTPUT);
  pinMode(ECHO_PIN, INPUT);
  attachInterrupt(digitalPinToInterrupt(ECHO_PIN), echoChanged, CHANGE);
  javino.perceive(look);
  javino.start(9600);
}

void loop() {
  measure();
  javino.run();
}
