#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <Arduino.h>

FakeSerial Serial;
unsigned long stub_millis;
int stub_pins[32];
