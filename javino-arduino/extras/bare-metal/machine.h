/**
 * @file The functions that a program needs from a microcontroller: serial ports and a clock. The machine.c of cortex-m, riscv, coldfire and
 * mips supply them. To support another machine, write a machine.c and a linker script for it.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The ports: the line to the computer, and a port for the pins of pins.h. */
enum { MACHINE_LINE, MACHINE_PANEL, MACHINE_PORTS };

/** The rate of both ports, in baud. */
#define MACHINE_BAUD 115200

/** Opens the ports and starts the clock and the interrupts. */
void machine_start(void);

/** @return milliseconds since machine_start; wraps around */
uint32_t machine_ms(void);

/** @return the oldest byte that the port has received and that nobody has taken, or -1 */
int machine_take(uint8_t port);

/** Puts a byte on a port. Waits while the port's transmitter is full; received bytes are kept during this wait. */
void machine_put(uint8_t port, uint8_t byte);

/** Sleeps until an interrupt comes, at most a millisecond. */
void machine_sleep(void);

#ifdef __cplusplus
}
#endif

#endif
