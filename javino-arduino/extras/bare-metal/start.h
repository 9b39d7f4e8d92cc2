/**
 * @file Common parts of all machines, for the interrupts and the first instructions of a machine.c: kept bytes, a count of milliseconds, and
 * the way to main.
 */
#ifndef START_H
#define START_H

#include "machine.h"

/** Keeps a byte that a port has received until machine_take. If there is no room, the byte is lost, as in a UART that nobody reads. */
void machine_receive(uint8_t port, uint8_t byte);

/** Counts one of the milliseconds of machine_ms. */
void machine_tick(void);

/** Halts the machine: exceptions end here. */
void machine_halt(void);

/** The first function, called with a stack: sets the memory up, calls constructors, then main. */
void machine_reset(void);

#endif
