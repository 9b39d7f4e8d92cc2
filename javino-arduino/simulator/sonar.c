#include "sonar.h"

#include <string.h>

#include "avr_ioport.h"

#define CYCLES_PER_US (BOARD_HZ / 1000000)
/* A trigger pulse lasts at least 10 us. A much longer pulse is no trigger. */
#define LEAST_TRIGGER (8 * CYCLES_PER_US)
#define LONGEST_TRIGGER (200 * CYCLES_PER_US)
/* The time from the trigger to the echo. The sensor sends eight periods of sound in this time. */
#define DELAY (450 * CYCLES_PER_US)
/* The time of sound for a centimetre there and back: 58.3 us. */
#define CYCLES_PER_CM 933u
#define NOTHING_IN_SIGHT (38000 * CYCLES_PER_US)

static avr_cycle_count_t falls(avr_t *avr, avr_cycle_count_t when, void *context)
{
    struct sonar_pin *echo = (struct sonar_pin *)context;
    (void)avr;
    (void)when;
    board_set_level(echo->sonar->board, echo->number, false);
    return 0;
}

static avr_cycle_count_t rises(avr_t *avr, avr_cycle_count_t when, void *context)
{
    struct sonar_pin *echo = (struct sonar_pin *)context;
    (void)when;
    board_set_level(echo->sonar->board, echo->number, true);
    avr_cycle_timer_register(avr, echo->cm ? (unsigned)echo->cm * CYCLES_PER_CM : NOTHING_IN_SIGHT, falls, echo);
    return 0;
}

static void answer(sonar *sonar)
{
    int pin;
    for (pin = 0; pin < BOARD_PINS; pin++)
        if (sonar->pins[pin].is_echo)
            avr_cycle_timer_register(sonar->board->avr, DELAY, rises, &sonar->pins[pin]);
}

static void changed(avr_irq_t *irq, uint32_t level, void *context)
{
    struct sonar_pin *pin = (struct sonar_pin *)context;
    uint64_t now = pin->sonar->board->avr->cycle;
    uint64_t length = now - pin->high_since;
    (void)irq;
    if (pin->is_echo)
        return;
    if (level && !pin->high_since)
        pin->high_since = now;
    if (level || !pin->high_since)
        return;
    pin->high_since = 0;
    if (length >= LEAST_TRIGGER && length <= LONGEST_TRIGGER)
        answer(pin->sonar);
}

void sonar_connect(sonar *sonar, board *board)
{
    int pin;
    memset(sonar, 0, sizeof *sonar);
    sonar->board = board;
    for (pin = 0; pin < BOARD_PINS; pin++) {
        sonar->pins[pin].sonar = sonar;
        sonar->pins[pin].number = pin;
        avr_irq_register_notify(board_irq(board, pin), changed, &sonar->pins[pin]);
    }
}

void sonar_set(sonar *sonar, int pin, int cm)
{
    sonar->pins[pin].is_echo = true;
    sonar->pins[pin].cm = cm;
}
