/** @file Commands with which a test sets inputs and reads outputs. */
#ifndef CONSOLE_H
#define CONSOLE_H

#include "board.h"
#include "sonar.h"

/**
 * Carries out one command and prints its answer. The answer is one line that begins with ok, pin or error.
 *
 * @param sonar    the sensors of the board
 * @param command  a line without its line end; console_do changes the text
 * @return false if the command was quit
 */
bool console_do(board *board, sonar *sonar, char *command);

/** A pin_watcher that prints the state of a pin as `pin 13 high 1234.567`. The last number is milliseconds since power-on. */
void console_pin(void *context, int pin, pin_state state, double ms);

#endif
