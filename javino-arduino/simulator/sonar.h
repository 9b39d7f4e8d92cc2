/** @file HC-SR04 distance sensors in front of the board. */
#ifndef SONAR_H
#define SONAR_H

#include "board.h"

/** The longest distance that a sensor measures, in centimetres. */
#define SONAR_MAX_CM 400

/**
 * The sensors and their distances. A sensor answers each trigger pulse with a pulse on its echo pin. All sensors answer a trigger pulse on
 * any pin, since a sketch with several sensors reads them one by one.
 */
typedef struct sonar {
    board *board;
    struct sonar_pin {
        struct sonar *sonar;
        int number;
        bool is_echo;
        int cm;              /* distance that this echo's sensor measures; 0: nothing in sight */
        uint64_t high_since; /* the cycle at which a possible trigger pulse began; 0: no pulse */
    } pins[BOARD_PINS];
} sonar;

/** Connects a board. The board has no sensors yet. */
void sonar_connect(sonar *sonar, board *board);

/**
 * Adds a sensor with its echo on this pin, or sets that sensor's distance.
 *
 * @param cm  the measured distance, at most SONAR_MAX_CM; 0 for nothing in sight, which gives a pulse of 38 ms
 */
void sonar_set(sonar *sonar, int pin, int cm);

#endif
