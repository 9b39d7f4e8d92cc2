/** @file The rates of serial lines. A byte is damaged between two ends whose rates differ. */
#ifndef RATE_H
#define RATE_H

#include <stdint.h>

/** @return the rate of a terminal in baud; 0 if no program has set one since rate_forget */
unsigned rate_of(int terminal);

void rate_forget(int terminal);

/**
 * Returns the byte that a receiver reads. If the rates differ by at most 3 %, this is the byte that was sent; otherwise it consists of the
 * bits that the receiver samples.
 *
 * @param sent      the sender's rate, in baud; 0 stands for the receiver's rate
 * @param received  the receiver's rate, in baud; 0 stands for the sender's rate
 */
uint8_t rate_sampled(uint8_t byte, unsigned sent, unsigned received);

#endif
