/** @file A serial line on two pins of the board, for sketches with SoftwareSerial. The line has 8 data bits, no parity, one stop bit. */
#ifndef SOFT_H
#define SOFT_H

#include "board.h"

/** The state of the line. All members are private. */
typedef struct {
    board *board;
    int receives; /* the board's pins */
    int sends;
    avr_cycle_count_t bit;
    byte_sink sink;
    void *context;
    uint8_t in[1024]; /* bytes to the board */
    unsigned in_begin;
    unsigned in_end;
    unsigned bits; /* remaining bits of the byte to the board, lowest first */
    int bits_left;
    int taken; /* number of received bits of the board's byte */
    uint8_t byte;
} soft;

/**
 * Connects the line.
 *
 * @param receives  the pin on which the board receives
 * @param sends     the pin on which the board sends
 * @param baud      the rate that the sketch has set
 * @param sink      called with each complete byte from the board
 */
void soft_connect(soft *soft, board *board, int receives, int sends, unsigned baud, byte_sink sink, void *context);

/** @return the number of bytes that soft_receive can take now */
unsigned soft_room(const soft *soft);

/** Sends a byte to the board, after all earlier bytes. */
void soft_receive(soft *soft, uint8_t byte);

#endif
