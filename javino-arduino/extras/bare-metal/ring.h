/**
 * @file
 * A ring buffer between a receive interrupt, which alone puts, and the main loop, which alone takes. Neither needs the other to stand
 * still on a machine with one core, since an index is written by one side only.
 */
#ifndef RING_H
#define RING_H

#include <stdint.h>

/** Bytes that a ring holds, and one; a power of two of at most 256. More than JAVINO_CREDIT. */
#define RING_BYTES 256

typedef struct {
    volatile uint8_t bytes[RING_BYTES];
    volatile uint16_t put;
    volatile uint16_t taken;
} ring;

/** Keeps a received byte. One that finds no room is lost, as in a UART that nobody reads. */
static inline void ring_put(ring *r, uint8_t byte)
{
    uint16_t next = (uint16_t)(r->put + 1) % RING_BYTES;
    if (next == r->taken)
        return;
    r->bytes[r->put] = byte;
    r->put = next;
}

/** @return the oldest byte, or -1 */
static inline int ring_take(ring *r)
{
    uint16_t at = r->taken;
    uint8_t byte;
    if (at == r->put)
        return -1;
    byte = r->bytes[at];
    r->taken = (uint16_t)(at + 1) % RING_BYTES;
    return byte;
}

#endif
