/** @file Distance sensors of the kind HC-SR04 in front of the board. */
#ifndef SONAR_H
#define SONAR_H

#include "board.h"

/** The range of a sonar, in centimetres. */
#define SONAR_MAX_CM 400

/**
 * The sensors and their distances. A sensor answers each trigger pulse with a pulse on the pin of its echo. All sensors answer a trigger
 * pulse on any pin: a sketch with several reads one after the other.
 */
typedef struct sonar {
    board *board;
    struct sonar_pin {
        struct sonar *sonar;
        int number;
        bool is_echo;
        int cm;              /* distance that the sensor of this echo measures; 0: nothing in sight */
        uint64_t high_since; /* the cycle at which a trigger pulse may have begun; 0: none has */
    } pins[BOARD_PINS];
} sonar;

/** Connects a board. It has no sensors yet. */
void sonar_connect(sonar *sonar, board *board);

/**
 * Adds a sensor whose echo is this pin, or sets its distance.
 *
 * @param cm  the distance it measures, at most SONAR_MAX_CM; 0 for nothing in sight, which gives a pulse of 38 ms
 */
void sonar_set(sonar *sonar, int pin, int cm);

#endif
