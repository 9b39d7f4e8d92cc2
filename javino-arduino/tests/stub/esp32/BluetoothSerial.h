#ifndef BLUETOOTH_SERIAL_STUB_H
#define BLUETOOTH_SERIAL_STUB_H

#include <Arduino.h>

/** As the ESP32's: its begin() takes a name, and no rate. */
class BluetoothSerial : public Stream {
public:
  bool begin(String localName = String(), bool isMaster = false) { return localName.length() == 0 || isMaster; }
  int available() override { return 0; }
  int read() override { return -1; }
  int peek() override { return -1; }
  size_t write(uint8_t) override { return 1; }
};

#endif
