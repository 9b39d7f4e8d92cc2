/** @file The commands by which a test sets inputs and reads outputs. */
#ifndef CONSOLE_H
#define CONSOLE_H

#include "board.h"
#include "sonar.h"

/**
 * Carries out one command and prints its answer: one line that begins with ok, pin or error.
 *
 * @param sonar    connected to the board
 * @param command  a line without its end; changed
 * @return false if it was quit
 */
bool console_do(board *board, sonar *sonar, char *command);

/** A pin_watcher. Prints the state of a pin: `pin 13 high 1234.567`, the time being milliseconds since power-on. */
void console_pin(void *context, int pin, pin_state state, double ms);

#endif
