// The robot of the bench of stops as the version 1 library in the field serves it: percepts, actions and pins are those
// of the sketch Stops. All that has arrived is read between two rounds of loop(), with room for one message. The first
// byte of the next frame empties it, and until the fifth the sketch takes it for a message still: there is no handler
// for "", so a null pointer is called. Compiled with BAUD and LOOP_MS.
#include <Arduino.h>

const uint8_t DRIVES = 8;
const uint8_t ACTED = 9;
const uint8_t LOOKED = 10;
const uint8_t STARTED = 11;

char message[256];
uint8_t length = 0, expected = 0, position = 0;
bool complete = false;
uint8_t reading = 0;

void toggle(uint8_t pin) {
  digitalWrite(pin, !digitalRead(pin));
}

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
  char header[7];
  snprintf(header, sizeof header, "fffe%02X", size);
  Serial.print(header);
  Serial.print(text);
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
  while (Serial.available())
    accept(Serial.read());
  if (complete) {
    complete = false;
    void (*volatile handler)() = !*message ? nullptr : strcmp(message, "getPercepts") ? act : answer;
    handler();
  }
  delay(LOOP_MS);
}
