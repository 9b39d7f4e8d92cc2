/* The stream of an 8051 that s51 simulates: a memory cell, by which a program reads and writes files of the simulator. */
#include "stream.h"

static volatile __xdata __at(0xFFFF) uint8_t door;

bool stream_read(void *bytes, uint16_t length)
{
    uint8_t *p = bytes;
    while (length--) {
        door = 'f'; /* is there a byte? */
        if (!door)
            return false;
        door = 'r';
        *p++ = door;
    }
    return true;
}

void stream_write(const void *bytes, uint16_t length)
{
    const uint8_t *p = bytes;
    while (length--) {
        door = 'w';
        door = *p++;
    }
}

void stream_end(void)
{
    for (;;)
        door = 's'; /* ends the simulator */
}
