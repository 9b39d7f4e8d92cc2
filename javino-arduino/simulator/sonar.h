/** @file HC-SR04 distance sensors in front of the board. */
#ifndef SONAR_H
#define SONAR_H

#include "board.h"

/** The longest distance of a sensor, in centimetres. */
#define SONAR_MAX_CM 400

/**
 * The sensors and their distances. A sensor answers a trigger pulse with a pulse on its echo pin. All sensors answer a trigger pulse on
 * any pin, because sketches read several sensors one by one.
 */
typedef struct sonar {
    board *board;
    struct sonar_pin {
        struct sonar *sonar;
        int number;
        bool is_echo;
        int cm;              /* distance of this echo's sensor; 0: nothing in sight */
        uint64_t high_since; /* cycle at which a possible trigger pulse began, or 0 */
    } pins[BOARD_PINS];
} sonar;

void sonar_connect(sonar *sonar, board *board);

/**
 * Adds a sensor whose echo is on this pin, or changes the distance of this sensor.
 *
 * @param cm  the measured distance, at most SONAR_MAX_CM; 0 for nothing in sight, which causes a pulse of 38 ms
 */
void sonar_set(sonar *sonar, int pin, int cm);

#endif
