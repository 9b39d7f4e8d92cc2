/**
 * @file Pins for machines under QEMU, which have none: the readings of sensors and the states of the program's outputs, as text on the
 * second serial port. The commands and lines are those of simulator/README.md: set, mux, watch and time.
 */
#ifndef PINS_H
#define PINS_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Pins. The pins from PIN_A0 on are analogue inputs too. */
enum { PIN_A0 = 14, PIN_COUNT = 22 };

/** Carries out the commands that have arrived. Call it in each turn of the main loop. */
void pins_poll(void);

/** Makes a pin an output that is low. */
void pin_output(uint8_t pin);

/** Sets an output high or low. */
void pin_write(uint8_t pin, bool high);

/** Turns an output on for duty/255 of the time. */
void pin_pwm(uint8_t pin, uint8_t duty);

/** @return the level of an output, or of an input as it was set */
bool pin_read(uint8_t pin);

/** @return 0 to 1023, for 0 to 5 V on this analogue input */
uint16_t pin_analogue(uint8_t pin);

#ifdef __cplusplus
}
#endif

#endif
