/** @file An Arduino Uno: an ATmega328P at 16 MHz. The pins have Arduino's names. */
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

typedef struct {
    enum { PIN_INPUT, PIN_LOW, PIN_HIGH, PIN_PWM } kind;
    uint8_t duty; /**< 0 to 255, for PIN_PWM. */
} pin_state;

typedef struct board board;

/** Called when a watched pin changes. `ms` is simulated time since power-on in milliseconds. */
typedef void (*pin_watcher)(void *context, int pin, pin_state state, double ms);

/** Called with each byte from the board, after the byte's last bit. */
typedef void (*byte_sink)(void *context, uint8_t byte);

/** Called when the board begins to send a byte. `cycle` is the cycle after the byte's last bit. */
typedef void (*byte_forecast)(void *context, uint8_t byte, uint64_t cycle);

/** The board. Only avr is public. */
struct board {
    avr_t *avr;
    void *context;
    pin_watcher watcher;
    byte_sink sink;
    byte_forecast forecast; /* if set, called in place of sink */
    bool watched[BOARD_PINS];
    pin_state last[BOARD_PINS];
    uint16_t millivolts[BOARD_ANALOGUE][BOARD_CHANNELS];
    bool converted[BOARD_ANALOGUE]; /* whether the sketch has read this input since power-on */
    uint8_t levels[BOARD_PINS];     /* external level of each pin: 1 low, 2 high, 0 none */
    int select_pins[BOARD_ANALOGUE][BOARD_SELECTS]; /* -1 for no pin */
    uint8_t in[4096];
    uint64_t in_at[4096]; /* cycle at which each byte begins; 0: right after the previous byte */
    unsigned in_begin;
    unsigned in_end;
    bool feeding;
    bool receiver_full; /* whether simavr's receiver is full */
    uint8_t out[4096];
    unsigned out_begin;
    unsigned out_end;
    bool sending;
    uint64_t out_free; /* cycle after the last bit of the last byte */
};

/**
 * Loads a sketch.
 *
 * @param firmware  an .elf or .hex file
 * @param sink receives the board's bytes; null if board_foretell sets a receiver
 * @return false, with a message on stderr, if the sketch cannot be loaded
 */
bool board_load(board *board, const char *firmware, pin_watcher watcher, byte_sink sink, void *context);

/** Runs the board up to this cycle, counted from power-on. @return false if the sketch has crashed or ended */
bool board_run(board *board, uint64_t cycle);

/** Presses the reset button. Simulated time continues. Bytes on the line are lost. */
void board_reset(board *board);

/** @return the number of bytes that board_receive can take now */
unsigned board_room(const board *board);

/** @return the rate of the board's serial line in baud; 0 if the sketch has not set a rate yet */
unsigned board_baud(const board *board);

/** Sends a byte to the board, at the rate that the board has set. */
void board_receive(board *board, uint8_t byte);

/** Sends a byte to the board. The byte's first bit begins at `cycle`. `cycle` must be in the future and after all earlier bytes. */
void board_receive_at(board *board, uint8_t byte, uint64_t cycle);

/** Passes the board's bytes to this function in place of the sink. */
void board_foretell(board *board, byte_forecast forecast);

/** @return the number of a pin with a name such as 13, A0 or PB5; -1 if there is no such pin */
int board_pin(const char *name);

pin_state board_state(const board *board, int pin);

/** Watches a pin: reports its state now and after each change. */
void board_watch(board *board, int pin);

/** @return simavr's signal for the level of a pin */
avr_irq_t *board_irq(const board *board, int pin);

/** @return true if an input is high */
bool board_level(const board *board, int pin);

/** @return true if an input has its pull-up resistor on */
bool board_pulls_up(const board *board, int pin);

/** Puts an external digital level on a pin. The level overrides the pin's pull-up, and lasts through a reset. */
void board_set_level(board *board, int pin, bool high);

/** Puts a voltage on an analogue input, or on a channel of the input's multiplexer. */
void board_set_millivolts(board *board, int input, int channel, uint16_t millivolts);

/** Puts a multiplexer in front of an analogue input. The select pins choose the channel. The first pin is the lowest bit. */
void board_multiplex(board *board, int input, const int *select_pins, int count);

/** @return milliseconds of simulated time since power-on */
double board_ms(const board *board);

#endif
