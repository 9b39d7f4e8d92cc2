/**
 * @file examples/Robot4WD without Arduino and without lamps, in C on the core. The program runs on every machine that has a machine.c.
 *
 *   actions   front  back  left  right  stop  speed(0..255)
 *   percepts  dist(Side,Cm)  light(Side,Level)  temp(Side,Celsius)   Side is f, b, r or l; Level is 0 to 1023
 *
 * The robot stops after a second without a message from the computer. The robot watches critical rules from the computer.
 */
#include <string.h>

#include "javino_board.h"
#include "javino_literal.h"
#include "javino_rules.h"
#include "machine.h"
#include "pins.h"

#define SILENCE_MS 1000
#define RULE_BYTES 96

enum { SIDES = 4, DISTANCE = PIN_A0, LIGHT = PIN_A0 + 4, TEMPERATURE = PIN_A0 + 5, SELECT_LOW = 2, SELECT_HIGH = 4 };

/* The pins of a pair of wheels. */
typedef struct {
    uint8_t speed;
    uint8_t forward;
    uint8_t backward;
} wheels;

static const wheels LEFT = {5, 7, 8};
static const wheels RIGHT = {6, 9, 10};

static uint32_t memory[(JAVINO_MEMORY + JAVINO_MAX_PAYLOAD + RULE_BYTES + 64) / 4]; /* aligned for pointers */
static javino_board board;
static uint8_t power = 200;

/* ---- Actions ---- */

static void turn(const wheels *w, int direction)
{
    pin_write(w->forward, direction > 0);
    pin_write(w->backward, direction < 0);
    pin_pwm(w->speed, direction ? power : 0);
}

static void drive(int left, int right)
{
    turn(&LEFT, left);
    turn(&RIGHT, right);
}

/* An action either drives the wheels or takes an argument. */
typedef struct {
    javino_action named; /* the core reads the names, at a distance of action_size */
    int8_t left;
    int8_t right;
} action;

static const action ACTIONS[] = {
    {{"speed", 1}, 0, 0}, {{"stop", 0}, 0, 0},   {{"right", 0}, 1, -1},
    {{"left", 0}, -1, 1}, {{"back", 0}, -1, -1}, {{"front", 0}, 1, 1},
};

enum { ACTION_COUNT = sizeof ACTIONS / sizeof *ACTIONS };

static bool set_speed(const char *text, uint8_t length)
{
    const char *argument;
    int32_t wanted;
    uint8_t bytes = javino_argument(text, length, 0, &argument);
    if (!bytes || !javino_number(argument, bytes, &wanted) || wanted < 0 || wanted > 255)
        return false;
    power = (uint8_t)wanted;
    return true;
}

static uint8_t argument_count(const char *text, uint8_t length)
{
    const char *argument;
    uint8_t n = 0;
    while (javino_argument(text, length, n, &argument))
        n++;
    return n;
}

/*
 * Carries out the text of an action. Returns false if the action is unknown or malformed.
 *
 * In version 1 a damaged length may truncate an action's text. No name here is the beginning of another name, and a text truncated within
 * its brackets is no literal. A truncated text is therefore never mistaken for another action. If one of your names is the beginning of
 * another, call javino_decoder_follows first.
 */
static bool act(void *context, const char *text, uint8_t length)
{
    uint8_t functor = javino_functor(text, length);
    uint8_t i;
    (void)context;
    for (i = 0; i < ACTION_COUNT; i++) {
        const action *a = &ACTIONS[i];
        if (strlen(a->named.name) != functor || memcmp(a->named.name, text, functor) != 0)
            continue;
        if (argument_count(text, length) != a->named.arguments)
            return false;
        if (a->named.arguments)
            return set_speed(text, length);
        drive(a->left, a->right);
        return true;
    }
    return false;
}

/* ---- Percepts ---- */

static void percept(const char *functor, const char *side, uint32_t value)
{
    if (!javino_percept_begin(&board, functor))
        return;
    javino_percept_put(&board, '(');
    javino_percept_text(&board, side);
    javino_percept_put(&board, ',');
    javino_percept_number(&board, value, false);
    javino_percept_put(&board, ')');
    javino_percept_end(&board);
}

static void look(void *context)
{
    static const char *const NAMES[SIDES] = {"f", "b", "r", "l"};
    uint8_t side;
    (void)context;
    for (side = 0; side < SIDES; side++) {
        percept("dist", NAMES[side], pin_analogue(DISTANCE + side) * 127u / 100);
        pin_write(SELECT_LOW, side & 1);
        pin_write(SELECT_HIGH, side & 2);
        percept("light", NAMES[side], pin_analogue(LIGHT));
        percept("temp", NAMES[side], pin_analogue(TEMPERATURE) * 500u / 1023);
    }
}

/* ---- The line ---- */

static void put_byte(void *context, uint8_t byte)
{
    (void)context;
    machine_put(MACHINE_LINE, byte);
}

/* Takes arrived bytes while the link has room. Returns the time at the call's beginning. */
static uint32_t take_bytes(void)
{
    uint32_t now = machine_ms();
    int byte;
    while (javino_link_ready(&board.link) && (byte = machine_take(MACHINE_LINE)) >= 0)
        javino_link_receive(&board.link, (uint8_t)byte, (uint16_t)now);
    return now;
}

static void turn_of_the_loop(void)
{
    uint32_t now = take_bytes();
    switch (javino_board_poll(&board, (uint16_t)now)) {
    case JAVINO_REQUEST:
        look(NULL);
        javino_board_answer(&board);
        break;
    case JAVINO_ACTION:
        javino_link_finish(&board.link, act(NULL, board.link.text, board.link.length));
        break;
    default:
        machine_sleep();
    }
    javino_rules_look(&board, look, (uint16_t)now);
    if (javino_link_lost(&board.link, SILENCE_MS, now))
        drive(0, 0);
    pins_poll();
}

int main(void)
{
    static const uint8_t OUTPUTS[] = {2, 4, 5, 6, 7, 8, 9, 10};
    uint8_t i;
    machine_start();
    for (i = 0; i < sizeof OUTPUTS; i++)
        pin_output(OUTPUTS[i]);
    javino_board_init(&board, memory, sizeof memory, put_byte, NULL);
    board.link.actions = ACTIONS;
    board.link.action_size = sizeof *ACTIONS;
    board.link.action_count = ACTION_COUNT;
    javino_rules_init(&board, RULE_BYTES, act, NULL);
    javino_link_timeout(&board.link, JAVINO_TIMEOUT_MS(MACHINE_BAUD));
    javino_link_supervise(&board.link, machine_ms());
    for (;;)
        turn_of_the_loop();
}
