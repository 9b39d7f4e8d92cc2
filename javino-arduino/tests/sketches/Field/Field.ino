// Receives as the version 1 library in the field does, for a test of the pace at which a computer sends.
//   actions   loopN: loop() takes N ms; buildN: an answer takes N ms to build; any other is counted
//   percepts  done(N): actions counted; starts(N): how often the sketch has started
#include "field.h"

#define KEPT __attribute__((section(".noinit"))) // through a restart
KEPT uint16_t done, starts;
KEPT uint8_t loopMs, buildMs;
KEPT uint32_t mark;
const uint32_t MARK = 0x4A61766FUL;

void answer() {
  char text[40];
  snprintf(text, sizeof text, "done(%u);starts(%u);", done, starts);
  delay(buildMs);
  sendMessage(text);
}

void act() {
  if (!strncmp(message, "loop", 4))
    loopMs = atoi(message + 4);
  else if (!strncmp(message, "build", 5))
    buildMs = atoi(message + 5);
  else
    done++;
}

void setup() {
  if (mark != MARK)
    done = starts = loopMs = buildMs = 0;
  mark = MARK;
  starts++;
  Serial.begin(9600);
}

void loop() {
  receive(answer, act);
  delay(loopMs);
}
