/** @file The interface of the Servo libraries of the ESP32, the ESP8266 and the Pico, as far as the examples use it. */
#ifndef SERVO_INTERFACE_STUB_H
#define SERVO_INTERFACE_STUB_H

class Servo {
public:
  int attach(int) { return 0; }
  void write(int) {}
};

#endif
