/**
 * @file The functions of a microcontroller that a program needs: serial ports and a clock. The machine.c of cortex-m, riscv, coldfire and
 * mips supply them; a port to another machine is one more such file with its linker script.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The line to the computer, and a second port for the pins of pins.h. */
enum { MACHINE_LINE, MACHINE_PANEL, MACHINE_PORTS };

/** Rate of both ports. */
#define MACHINE_BAUD 115200

/** Opens the ports and starts the clock and the interrupts. */
void machine_start(void);

/** @return milliseconds since machine_start; wraps around */
uint32_t machine_ms(void);

/** @return the oldest byte that the port has received, or -1 */
int machine_take(uint8_t port);

/** Puts a byte on a port; waits while its transmitter is full. The interrupt keeps bytes that arrive meanwhile. */
void machine_put(uint8_t port, uint8_t byte);

/** Sleeps until an interrupt, at most a millisecond. */
void machine_sleep(void);

#ifdef __cplusplus
}
#endif

#endif
