/**
 * @file The stream of bytes from the test that drives a board, and back: standard input and output of a program, or files of a simulator.
 */
#ifndef STREAM_H
#define STREAM_H

#include <stdbool.h>
#include <stdint.h>

/** @return false if the stream has ended */
bool stream_read(void *bytes, uint16_t length);

void stream_write(const void *bytes, uint16_t length);

/** Ends the program. Behind an error the test misses answers. */
void stream_end(void);

#endif
