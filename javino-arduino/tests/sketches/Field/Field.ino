// Receives as the version 1 library in the field does, for a test of the pace at which a computer sends: all that has
// arrived is read between two rounds of loop(), with room for one message. The first byte of the next frame empties it,
// and until the fifth the sketch takes it for a message still: there is no handler for "", so a null pointer is called.
//   actions   loopN: loop() takes N ms; buildN: an answer takes N ms to build; any other is counted
//   percepts  done(N): actions counted; starts(N): how often the sketch has started
#include <Arduino.h>

#define KEPT __attribute__((section(".noinit"))) // through a restart
KEPT uint16_t done, starts;
KEPT uint8_t loopMs, buildMs;
KEPT uint32_t mark;
const uint32_t MARK = 0x4A61766FUL;

char message[256];
uint8_t length = 0, expected = 0, position = 0;
bool complete = false;

void accept(char c) {
  if (position == 0)
    message[length = 0] = 0;
  position++;
  if (position <= 4) {
    if (c != "fffe"[position - 1])
      position = 0;
  } else if (position <= 6) {
    complete = false;
    expected = expected << 4 | (c <= '9' ? c - '0' : (c | 32) - 'a' + 10);
  } else {
    message[length++] = c;
    message[length] = 0;
  }
  if (position >= 6 && length == expected) {
    complete = true;
    position = 0;
  }
}

void answer() {
  char text[40];
  int size = snprintf(text, sizeof text, "done(%u);starts(%u);", done, starts);
  delay(buildMs);
  char header[7];
  snprintf(header, sizeof header, "fffe%02X", size);
  Serial.print(header);
  Serial.print(text);
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
  while (Serial.available())
    accept(Serial.read());
  if (complete) {
    complete = false;
    void (*volatile handler)() = !*message ? nullptr : strcmp(message, "getPercepts") ? act : answer;
    handler();
  }
  delay(loopMs);
}
