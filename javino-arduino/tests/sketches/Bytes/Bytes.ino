// Counts bytes, without the library, and prints how many there were before the end of a line.

#include <Arduino.h>

unsigned bytes = 0;

void setup() {
  Serial.begin(115200);
}

void loop() {
  while (Serial.available() > 0) {
    if (Serial.read() == '\n') {
      Serial.println(bytes);
      bytes = 0;
    } else {
      bytes++;
    }
  }
}
