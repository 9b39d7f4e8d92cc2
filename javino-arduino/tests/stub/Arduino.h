/**
 * @file
 * As much of the Arduino API as the library and its tests use, for the host. Time stands still until a test
 * moves it, and Serial is two queues that a test fills and empties.
 */
#ifndef ARDUINO_STUB_H
#define ARDUINO_STUB_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <deque>
#include <string>

#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define INPUT_PULLUP 2
#define LED_BUILTIN 13
#define A0 14
#define A1 15
#define A2 16
#define A3 17
/* As on an Uno: 63 bytes wait. */
#define SERIAL_RX_BUFFER_SIZE 64
#define A4 18
#define A5 19
#define CHANGE 3
#define digitalPinToInterrupt(pin) (pin)

#if defined(ESP32) || defined(ESP8266)
#define IRAM_ATTR
#endif
#ifdef ESP32
#include "esp32/freertos/FreeRTOS.h"
#endif

#define strlen_P strlen
#define memcpy_P memcpy

class __FlashStringHelper;
#define F(text) (reinterpret_cast<const __FlashStringHelper *>(text))

typedef bool boolean;
typedef uint8_t byte;

class String {
public:
  String(const char *text = "") : text_(text) {}
  String(const __FlashStringHelper *text) : text_(reinterpret_cast<const char *>(text)) {}
  explicit String(char c) : text_(1, c) {}
  explicit String(int n) : text_(std::to_string(n)) {}
  explicit String(long n) : text_(std::to_string(n)) {}
  explicit String(unsigned long n) : text_(std::to_string(n)) {}
  const char *c_str() const { return text_.c_str(); }
  unsigned length() const { return static_cast<unsigned>(text_.size()); }
  unsigned char reserve(unsigned n) { text_.reserve(n); return 1; }
  String &operator+=(char c) { text_ += c; return *this; }
  String &operator+=(const String &other) { text_ += other.text_; return *this; }
  bool operator==(const char *text) const { return text_ == text; }
  bool operator==(const String &other) const { return text_ == other.text_; }
  friend String operator+(String left, const String &right) { return left += right; }

private:
  std::string text_;
};

class Stream {
public:
  virtual ~Stream() {}
  virtual int available() = 0;
  virtual int read() = 0;
  virtual int peek() = 0;
  virtual size_t write(uint8_t byte) = 0;
  virtual size_t write(const uint8_t *bytes, size_t n) {
    size_t written = 0;
    while (written < n && write(bytes[written]))
      written++;
    return written;
  }
  virtual int availableForWrite() { return 0; }
};

/** A port whose far end a test holds. */
class FakeSerial : public Stream {
public:
  std::deque<uint8_t> in;
  std::string out;
  unsigned long baud = 0;
  /** Bytes that arrive while one is written, as on a line that works in both directions. */
  std::deque<uint8_t> meanwhile;
  /** While false, it takes nothing that is written; `refused` counts those writes. */
  bool takes = true;
  int refused = 0;

  /** The number of writes. */
  int writes = 0;

  void begin(unsigned long rate) { baud = rate; }
  template <typename Value> void print(const Value &) {}
  template <typename Value> void println(const Value &) {}
  void receive(const std::string &bytes) { in.insert(in.end(), bytes.begin(), bytes.end()); }
  std::string sent() { std::string bytes; bytes.swap(out); return bytes; }

  int available() override { return static_cast<int>(in.size()); }
  int read() override {
    if (in.empty())
      return -1;
    int byte = in.front();
    in.pop_front();
    return byte;
  }
  int peek() override { return in.empty() ? -1 : in.front(); }
  size_t write(const uint8_t *bytes, size_t n) override {
    size_t written = Stream::write(bytes, n);
    writes -= static_cast<int>(written) - 1;
    return written;
  }
  size_t write(uint8_t byte) override {
    if (!takes) {
      refused++;
      return 0;
    }
    writes++;
    out += static_cast<char>(byte);
    if (!meanwhile.empty()) {
      in.push_back(meanwhile.front());
      meanwhile.pop_front();
    }
    return 1;
  }
};

#ifndef STUB_WITHOUT_SERIAL
extern FakeSerial Serial;
extern FakeSerial Serial1;
#endif
extern unsigned long stub_millis;
extern int stub_pins[40];

inline unsigned long millis() { return stub_millis; }
inline unsigned long micros() { return stub_millis * 1000; }
inline void delay(unsigned long ms) { stub_millis += ms; }
inline void delayMicroseconds(unsigned) {}
inline unsigned long pulseIn(int pin, int, unsigned long) { return (unsigned long)stub_pins[pin]; }
inline void attachInterrupt(int, void (*)(), int) {}
inline void noInterrupts() {}
inline void interrupts() {}
inline void pinMode(int, int) {}
inline void digitalWrite(int pin, int value) { stub_pins[pin] = value; }
inline int digitalRead(int pin) { return stub_pins[pin]; }
inline void analogWrite(int pin, int value) { stub_pins[pin] = value; }
inline int analogRead(int pin) { return stub_pins[pin]; }

#endif
