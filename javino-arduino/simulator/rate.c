#include "rate.h"

#include <asm/termbits.h> /* instead of termios.h, which has only rates with a name */
#include <sys/ioctl.h>

/* The mark of a terminal whose rate no program has set. Nobody asks for this rate. */
#define NO_RATE B50
#define TOLERANCE_PERCENT 3

/* A byte on the line is a start bit, the data from the lowest bit on, and the idle line. */
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
         * The receiver counts its bits from the start bit, and samples in the middle of each of them. This is the place in the sender's
         * bits.
         */
        unsigned long long place = (2 * bit + 3) * (unsigned long long)sent / (2ull * received);
        if (place > DATA_BITS || (place > 0 && byte >> (place - 1) & 1))
            sampled |= (uint8_t)(1 << bit);
    }
    return sampled;
}
