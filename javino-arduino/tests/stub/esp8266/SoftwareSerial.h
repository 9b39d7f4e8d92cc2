#ifndef SOFTWARE_SERIAL_STUB_H
#define SOFTWARE_SERIAL_STUB_H

#include <Arduino.h>

/** The interface of the ESP8266 core's, as far as the examples use it. */
class SoftwareSerial : public FakeSerial {
public:
  SoftwareSerial(int8_t, int8_t) {}
};

#endif
