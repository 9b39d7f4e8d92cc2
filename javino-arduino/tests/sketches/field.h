// Receives as the version 1 library in the field does: all bytes that have arrived are read between two rounds of loop(), with room for one
// message. The first byte of the next frame empties it, and until the fifth the sketch takes it for a message still: there is no handler
// for "", so a null pointer is called.
#ifndef FIELD_H
#define FIELD_H

#include <Arduino.h>

char message[256];
uint8_t length = 0, expected = 0, position = 0;
bool complete = false;

inline void accept(char c) {
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

/** Reads the bytes that have arrived, and handles the message if there is one. */
inline void receive(void (*answer)(), void (*act)()) {
  while (Serial.available())
    accept(Serial.read());
  if (complete) {
    complete = false;
    void (*volatile handler)() = !*message ? nullptr : strcmp(message, "getPercepts") ? act : answer;
    handler();
  }
}

inline void sendMessage(const char *text) {
  char header[7];
  snprintf(header, sizeof header, "fffe%02X", static_cast<unsigned>(strlen(text)));
  Serial.print(header);
  Serial.print(text);
}

#endif
