/** @file An Arduino Uno: an ATmega328P at 16 MHz, with its pins as the Arduino names them. */
#ifndef BOARD_H
#define BOARD_H

#include <stdbool.h>
#include <stdint.h>

#include "sim_avr.h"

#define BOARD_HZ 16000000ull
#define BOARD_PINS 20
#define BOARD_ANALOGUE 8
#define BOARD_SELECTS 4
#define BOARD_CHANNELS (1 << BOARD_SELECTS)

/** The state of a pin. */
typedef struct {
    enum { PIN_INPUT, PIN_LOW, PIN_HIGH, PIN_PWM } kind;
    uint8_t duty; /**< Of 255, for PIN_PWM. */
} pin_state;

typedef struct board board;

/** Called when a watched pin changes. */
typedef void (*pin_watcher)(void *context, int pin, pin_state state, double ms);

/** Called with each byte that the board sends, at the moment at which the byte's last bit would have left. */
typedef void (*byte_sink)(void *context, uint8_t byte);

/** Called when the board begins to send a byte, with the cycle at which the byte's last bit will have left. */
typedef void (*byte_forecast)(void *context, uint8_t byte, uint64_t cycle);

/** The board. The members are private except avr. */
struct board {
    avr_t *avr;
    void *context;
    pin_watcher watcher;
    byte_sink sink;
    byte_forecast forecast; /* called in place of sink; may be null */
    bool watched[BOARD_PINS];
    pin_state last[BOARD_PINS];
    uint16_t millivolts[BOARD_ANALOGUE][BOARD_CHANNELS];
    bool converted[BOARD_ANALOGUE]; /* read since power-on */
    uint8_t levels[BOARD_PINS];     /* level put on a pin from outside: 1 low, 2 high; 0: none */
    int select_pins[BOARD_ANALOGUE][BOARD_SELECTS]; /* -1: none */
    uint8_t in[4096];
    uint64_t in_at[4096]; /* the cycle at which each byte begins; 0: behind the byte before */
    unsigned in_begin;
    unsigned in_end;
    bool feeding;
    bool receiver_full; /* simavr takes no more bytes for now */
    uint8_t out[4096];
    unsigned out_begin;
    unsigned out_end;
    bool sending;
    uint64_t out_free; /* the cycle at which the last byte of a forecast will have left */
};

/**
 * Loads a sketch.
 *
 * @param firmware  an .elf or .hex file
 * @param sink takes the board's bytes; null: board_foretell gives a receiver
 * @return false, with a message on stderr, if the sketch cannot be loaded
 */
bool board_load(board *board, const char *firmware, pin_watcher watcher, byte_sink sink, void *context);

/** Runs until this number of cycles has passed since power-on. @return false if the sketch has crashed or ended */
bool board_run(board *board, uint64_t cycle);

/** Presses the reset button. Time goes on; bytes on the line are lost. */
void board_reset(board *board);

/** @return how many bytes board_receive takes at present */
unsigned board_room(const board *board);

/** @return the rate of the board's serial line; 0 until the sketch has set one */
unsigned board_baud(const board *board);

/** Sends a byte to the board; it arrives by the rate that the board has set. */
void board_receive(board *board, uint8_t byte);

/** Sends a byte to the board; its first bit comes at this cycle, which has not passed and is not before those of earlier bytes. */
void board_receive_at(board *board, uint8_t byte, uint64_t cycle);

/** Hands the bytes that the board sends from now on to this instead of the sink. */
void board_foretell(board *board, byte_forecast forecast);

/** @return the number of a pin named 13, A0 or PB5; -1 if there is none of that name */
int board_pin(const char *name);

/** @return the present state of a pin */
pin_state board_state(const board *board, int pin);

/** Watches a pin. */
void board_watch(board *board, int pin);

/** @return the line of simavr that carries the level of a pin, driven by the board or from outside */
avr_irq_t *board_irq(const board *board, int pin);

/** @return true if a pin that is an input is high */
bool board_level(const board *board, int pin);

/** @return true if a pin that is an input has its pull-up resistor on */
bool board_pulls_up(const board *board, int pin);

/** Puts a digital level on a pin. It stays there, whatever the pin's pull-up does, and over a reset. */
void board_set_level(board *board, int pin, bool high);

/** Puts a voltage on an analogue input, or on a channel of the multiplexer in front of it. */
void board_set_millivolts(board *board, int input, int channel, uint16_t millivolts);

/** Puts a multiplexer in front of an analogue input; the pins select its channel, the lowest bit first. */
void board_multiplex(board *board, int input, const int *select_pins, int count);

/** @return milliseconds of simulated time since power-on */
double board_ms(const board *board);

#endif
