/**
 * @file Code for all machines: received bytes, a count of milliseconds, and the start before main. A machine.c calls these functions from
 *     its interrupts and its first instructions.
 */
#ifndef START_H
#define START_H

#include "machine.h"

/** Keeps a received byte until machine_take returns it. If there is no room, the byte is lost. */
void machine_receive(uint8_t port, uint8_t byte);

/** Adds a millisecond to the count of machine_ms. */
void machine_tick(void);

/** Halts the machine. Exceptions end here. */
void machine_halt(void);

/** The first C function. Sets up the memory, calls constructors, and calls main. The caller must have set up a stack. */
void machine_reset(void);

#endif
