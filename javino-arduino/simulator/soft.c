#include "soft.h"

#include <string.h>

enum { DATA_BITS = 8, FRAME_BITS = DATA_BITS + 2, STOP = 1 << (DATA_BITS + 1) };

/* ---- To the board ---- */

static void next(soft *s)
{
    s->bits = (unsigned)s->in[s->in_begin] << 1 | STOP;
    s->bits_left = FRAME_BITS;
    s->in_begin = (s->in_begin + 1) % sizeof s->in;
}

static avr_cycle_count_t put_bit(avr_t *avr, avr_cycle_count_t when, void *context)
{
    soft *s = (soft *)context;
    (void)avr;
    if (s->bits_left == 0) {
        if (s->in_begin == s->in_end)
            return 0;
        next(s);
    }
    board_set_level(s->board, s->receives, s->bits & 1);
    s->bits >>= 1;
    s->bits_left--;
    return when + s->bit;
}

unsigned soft_room(const soft *soft)
{
    return (unsigned)((soft->in_begin + sizeof soft->in - soft->in_end - 1) % sizeof soft->in);
}

void soft_receive(soft *soft, uint8_t byte)
{
    bool is_idle = soft->in_begin == soft->in_end && avr_cycle_timer_status(soft->board->avr, put_bit, soft) == 0;
    soft->in[soft->in_end] = byte;
    soft->in_end = (soft->in_end + 1) % sizeof soft->in;
    if (is_idle)
        avr_cycle_timer_register(soft->board->avr, soft->bit, put_bit, soft);
}

/* ---- From the board ---- */

static bool is_high(const soft *s)
{
    return board_state(s->board, s->sends).kind == PIN_HIGH;
}

/* Samples in the middle of each bit. Without a stop bit, the sketch uses the pin for another purpose and the bits are ignored. */
static avr_cycle_count_t take_bit(avr_t *avr, avr_cycle_count_t when, void *context)
{
    soft *s = (soft *)context;
    (void)avr;
    if (s->taken < DATA_BITS) {
        s->byte |= (uint8_t)(is_high(s) << s->taken++);
        return when + s->bit;
    }
    if (is_high(s))
        s->sink(s->context, s->byte);
    return 0;
}

static void changed(avr_irq_t *irq, uint32_t level, void *context)
{
    soft *s = (soft *)context;
    (void)irq;
    if (level || avr_cycle_timer_status(s->board->avr, take_bit, s))
        return;
    s->taken = 0;
    s->byte = 0;
    avr_cycle_timer_register(s->board->avr, s->bit + s->bit / 2, take_bit, s);
}

void soft_connect(soft *soft, board *board, int receives, int sends, unsigned baud, byte_sink sink, void *context)
{
    memset(soft, 0, sizeof *soft);
    soft->board = board;
    soft->receives = receives;
    soft->sends = sends;
    soft->bit = (BOARD_HZ + baud / 2) / baud;
    soft->sink = sink;
    soft->context = context;
    board_set_level(board, receives, true);
    avr_irq_register_notify(board_irq(board, sends), changed, soft);
}
