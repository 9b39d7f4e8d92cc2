#include "rate.h"

#include <asm/termbits.h> /* instead of termios.h, which has only rates with a name */
#include <sys/ioctl.h>

/* Marks a terminal whose rate no program has set. Programs do not use this rate. */
#define NO_RATE B50
#define TOLERANCE_PERCENT 3

/* A byte on the line is a start bit and the data bits, lowest first. The idle line follows. */
#define DATA_BITS 8

unsigned rate_of(int terminal)
{
    struct termios2 settings;
    if (ioctl(terminal, TCGETS2, &settings) != 0 || (settings.c_cflag & CBAUD) == NO_RATE)
        return 0;
    return settings.c_ospeed;
}

void rate_forget(int terminal)
{
    struct termios2 settings;
    if (ioctl(terminal, TCGETS2, &settings) != 0)
        return;
    settings.c_cflag = (settings.c_cflag & ~(tcflag_t)CBAUD) | NO_RATE;
    ioctl(terminal, TCSETS2, &settings);
}

uint8_t rate_sampled(uint8_t byte, unsigned sent, unsigned received)
{
    unsigned difference = sent > received ? sent - received : received - sent;
    uint8_t sampled = 0;
    unsigned bit;
    if (!sent || !received || difference * 100 <= received * TOLERANCE_PERCENT)
        return byte;
    for (bit = 0; bit < DATA_BITS; bit++) {
        /*
         * The receiver counts bits from the start bit on and samples in the middle of each bit. `place` is the sender's bit at that
         * moment.
         */
        unsigned long long place = (2 * bit + 3) * (unsigned long long)sent / (2ull * received);
        if (place > DATA_BITS || (place > 0 && byte >> (place - 1) & 1))
            sampled |= (uint8_t)(1 << bit);
    }
    return sampled;
}
