/**
 * @file
 * As much of the Servo library as the examples use, for one servo on an AVR with a Timer1: pulses by its interrupt, as that library makes
 * them. The library itself comes with the Arduino IDE, and not with the core.
 */
#ifndef SERVO_STUB_H
#define SERVO_STUB_H

#include <Arduino.h>

/* Pulses of 544 to 2,400 microseconds every 20 ms; the timer counts half microseconds. */
static volatile uint8_t servo_pin;
static volatile uint16_t servo_ticks;

ISR(TIMER1_COMPA_vect) {
  bool rises = !digitalRead(servo_pin);
  OCR1A += rises ? servo_ticks : 40000 - servo_ticks;
  digitalWrite(servo_pin, rises);
}

class Servo {
public:
  uint8_t attach(int pin) {
    servo_pin = static_cast<uint8_t>(pin);
    pinMode(servo_pin, OUTPUT);
    write(90);
    TCCR1A = 0;
    TCCR1B = _BV(CS11);
    OCR1A = 100;
    TCNT1 = 0;
    TIMSK1 = _BV(OCIE1A);
    return 0;
  }
  void write(int degrees) {
    uint16_t ticks = static_cast<uint16_t>(2 * (544 + (2400L - 544) * degrees / 180));
    noInterrupts();
    servo_ticks = ticks;
    interrupts();
  }
};

#endif
