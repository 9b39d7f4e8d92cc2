/** @file Rates of serial lines, and the damage to a byte between two ends with different rates. */
#ifndef RATE_H
#define RATE_H

#include <stdint.h>

/** The rate of a terminal, in baud; 0: no program has set one since rate_forget. */
unsigned rate_of(int terminal);

/** Marks a terminal as one whose rate no program has set. */
void rate_forget(int terminal);

/**
 * Returns the byte that a receiver reads: the same, if the rates differ by at most 3 %; else the bits that it samples.
 *
 * @param sent      the sender's rate, in baud; 0: the receiver's rate
 * @param received  the receiver's rate, in baud; 0: the sender's rate
 */
uint8_t rate_sampled(uint8_t byte, unsigned sent, unsigned received);

#endif
