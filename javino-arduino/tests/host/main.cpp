#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <Arduino.h>

FakeSerial Serial;
FakeSerial Serial1;
unsigned long stub_millis;
int stub_pins[40];
