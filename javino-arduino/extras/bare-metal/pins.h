/**
 * @file Simulated pins for machines under QEMU. On the second serial port, a test sets sensor readings and receives the states of outputs
 *     as text. simulator/README.md describes the commands set, mux, watch and time.
 */
#ifndef PINS_H
#define PINS_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The number of the first analogue input, and the number of pins. Pins from PIN_A0 on are also digital pins. */
enum { PIN_A0 = 14, PIN_COUNT = 22 };

/** Carries out the commands that have arrived. Call this in each run of the main loop. */
void pins_poll(void);

/** Makes a pin an output, low at first. */
void pin_output(uint8_t pin);

/** Sets an output high or low. */
void pin_write(uint8_t pin, bool high);

/** Turns an output on for duty/255 of the time. */
void pin_pwm(uint8_t pin, uint8_t duty);

/** @return the level of an output, or an input's level as a test has set it */
bool pin_read(uint8_t pin);

/** @return 0 to 1023, for 0 to 5 V on an analogue input */
uint16_t pin_analogue(uint8_t pin);

#ifdef __cplusplus
}
#endif

#endif
