/**
 * @file
 * As much of the Arduino API as the sketches in the tests use, on the machines of extras/.
 */
#ifndef MACHINES_ARDUINO_H
#define MACHINES_ARDUINO_H

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "machine.h"
#include "pins.h"

#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define LED_BUILTIN 13
#define A0 14
#define A1 15
#define A2 16
#define A3 17
#define A4 18
#define A5 19

#define strlen_P strlen
#define memcpy_P memcpy

class __FlashStringHelper;
#define F(text) (reinterpret_cast<const __FlashStringHelper *>(text))

/** Text of at most 299 bytes, without a heap; a longer text is cut off. */
class String {
public:
  String(const char *text = "") : length_(0) { append(text); }
  String(const __FlashStringHelper *text) : length_(0) { append(reinterpret_cast<const char *>(text)); }
  explicit String(unsigned long n) : length_(0) {
    if (n > 9)
      append(String(n / 10).text_);
    *this += static_cast<char>('0' + n % 10);
  }
  const char *c_str() const { return text_; }
  unsigned length() const { return length_; }
  void reserve(unsigned) {}
  String &operator+=(char c) {
    if (length_ < sizeof text_ - 1)
      text_[length_++] = c;
    text_[length_] = 0;
    return *this;
  }
  friend String operator+(String left, const String &right) {
    left.append(right.text_);
    return left;
  }

private:
  void append(const char *text) {
    text_[length_] = 0;
    while (*text)
      *this += *text++;
  }

  char text_[300];
  uint16_t length_;
};

class Stream {
public:
  virtual int available() = 0;
  virtual int read() = 0;
  virtual size_t write(uint8_t byte) = 0;
  virtual int availableForWrite() { return 0; }
};

/** The machine's line. */
class MachineSerial : public Stream {
public:
  void begin(unsigned long) {}
  int available() override { return next_ >= 0 || (next_ = machine_take(MACHINE_LINE)) >= 0; }
  int read() override {
    int byte = available() ? next_ : -1;
    next_ = -1;
    return byte;
  }
  size_t write(uint8_t byte) override {
    machine_put(MACHINE_LINE, byte);
    return 1;
  }

private:
  int next_ = -1;
};

extern MachineSerial Serial;

inline unsigned long millis() { return machine_ms(); }
inline unsigned long micros() { return machine_ms() * 1000; }
inline void delay(unsigned long ms) {
  for (unsigned long begin = machine_ms(); machine_ms() - begin < ms; machine_sleep())
    pins_poll();
}
inline void pinMode(uint8_t pin, uint8_t mode) {
  if (mode == OUTPUT)
    pin_output(pin);
}
inline void digitalWrite(uint8_t pin, int value) { pin_write(pin, value != LOW); }
inline int digitalRead(uint8_t pin) { return pin_read(pin); }
inline void analogWrite(uint8_t pin, int value) { pin_pwm(pin, static_cast<uint8_t>(value)); }
inline int analogRead(uint8_t pin) { return pin_analogue(pin); }

#endif
