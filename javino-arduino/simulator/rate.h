/** @file The rates of serial lines. If the two ends have different rates, bytes are garbled. */
#ifndef RATE_H
#define RATE_H

#include <stdint.h>

/** @return the rate of a terminal in baud; 0 if no program has set a rate since rate_forget */
unsigned rate_of(int terminal);

void rate_forget(int terminal);

/**
 * Returns the byte that a receiver reads. If the rates differ by at most 3 %, the receiver reads the sent byte. Otherwise the receiver
 * reads the bits that it samples.
 *
 * @param sent      the sender's rate in baud; 0 for the receiver's rate
 * @param received  the receiver's rate in baud; 0 for the sender's rate
 */
uint8_t rate_sampled(uint8_t byte, unsigned sent, unsigned received);

#endif
