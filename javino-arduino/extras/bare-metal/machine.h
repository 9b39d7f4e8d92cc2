/**
 * @file The functions that a program needs from a microcontroller: serial ports and a clock. The folders cortex-m, riscv, coldfire and
 *     mips have a machine.c with these functions. To support another machine, write a machine.c and a linker script.
 */
#ifndef MACHINE_H
#define MACHINE_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The ports: the line to the computer, and the panel, which pins.h uses. */
enum { MACHINE_LINE, MACHINE_PANEL, MACHINE_PORTS };

/** The rate of both ports in baud. */
#define MACHINE_BAUD 115200

/** Opens the ports and starts the clock and the interrupts. */
void machine_start(void);

/** @return milliseconds since machine_start; the value wraps around */
uint32_t machine_ms(void);

/** @return the oldest byte that the port has received and machine_take has not returned yet, or -1 */
int machine_take(uint8_t port);

/** Sends a byte on a port. Waits while the port's transmitter is full. Bytes received during the wait are kept. */
void machine_put(uint8_t port, uint8_t byte);

/** Sleeps until an interrupt comes, at most a millisecond. */
void machine_sleep(void);

#ifdef __cplusplus
}
#endif

#endif
