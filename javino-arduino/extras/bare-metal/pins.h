/**
 * @file Pins for machines under QEMU, which have no pins. A test sets readings of sensors and gets the states of outputs as text on the
 * second serial port. simulator/README.md describes the commands and lines; set, mux, watch and time are supported.
 */
#ifndef PINS_H
#define PINS_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The number of the first analogue input, and of all pins. The pins from PIN_A0 on are digital pins too. */
enum { PIN_A0 = 14, PIN_COUNT = 22 };

/** Carries out the commands that have arrived. Call this function in each turn of the main loop. */
void pins_poll(void);

/** Makes a pin an output that is low. */
void pin_output(uint8_t pin);

/** Sets an output high or low. */
void pin_write(uint8_t pin, bool high);

/** Turns an output on for duty/255 of the time. */
void pin_pwm(uint8_t pin, uint8_t duty);

/** @return the level of an output, or the level that a test has set for an input */
bool pin_read(uint8_t pin);

/** @return 0 to 1023, for 0 to 5 V on an analogue input */
uint16_t pin_analogue(uint8_t pin);

#ifdef __cplusplus
}
#endif

#endif
