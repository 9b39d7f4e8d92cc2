/**
 * @file The common WiFi interface of the ESP32's, the ESP8266's and the Pico W's Arduino cores, written after theirs: enough to compile and
 * run sketches on this machine. It is not their code, and no radio.
 */
#ifndef NETWORK_STUB_H
#define NETWORK_STUB_H

#include <Arduino.h>

#define WIFI_STA 1

typedef enum { WL_IDLE_STATUS = 0, WL_CONNECTED = 3, WL_DISCONNECTED = 6 } wl_status_t;

class IPAddress {};

/** A connection whose far end a test holds; copies are the same connection. Without begin(), as in the cores. */
class WiFiClient : public Stream {
public:
  explicit WiFiClient(FakeSerial *far = NULL) : far_(far) {}
  int available() override { return far_ ? far_->available() : 0; }
  int read() override { return far_ ? far_->read() : -1; }
  int peek() override { return far_ ? far_->peek() : -1; }
  size_t write(uint8_t byte) override { return write(&byte, 1); }
  size_t write(const uint8_t *bytes, size_t n) override { return far_ ? far_->write(bytes, n) : 0; }
  explicit operator bool() { return far_ != NULL; }
  uint8_t connected() { return far_ != NULL; }
  void stop() { far_ = NULL; }
  void setNoDelay(bool) {}

private:
  FakeSerial *far_;
};

class WiFiServer {
public:
  explicit WiFiServer(uint16_t) {}
  void begin() { began++; }
  WiFiClient accept() {
    WiFiClient found(next);
    next = NULL;
    return found;
  }

  FakeSerial *next = NULL;
  int began = 0;
};

class WiFiClass {
public:
  void mode(int) {}
  int begin(const char *, const char *) { return ++tries; }
  wl_status_t status() { return state; }
  IPAddress localIP() { return IPAddress(); }
  int32_t RSSI() { return -60; }

  wl_status_t state = WL_DISCONNECTED;
  int tries = 0;
};

extern WiFiClass WiFi;

#endif
