/**
 * @file A ring buffer between a receive interrupt, the only one that puts, and the main loop, the only one that takes. On a machine with
 * one core neither needs to lock out the other, since only one side writes each index.
 */
#ifndef RING_H
#define RING_H

#include <stdint.h>

/** One more than the bytes that a ring holds; a power of two of at most 256. More than JAVINO_CREDIT. */
#define RING_BYTES 256

typedef struct {
    volatile uint8_t bytes[RING_BYTES];
    volatile uint16_t put;
    volatile uint16_t taken;
} ring;

/** Keeps a received byte. If there is no room, the byte is lost, as in a UART that nobody reads. */
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
