/** @file A board whose time advances only on command. */
#ifndef STEPPED_H
#define STEPPED_H

#include <stdbool.h>

/**
 * Runs a sketch step by step. Reads commands from standard input and prints answers to standard output. README.md describes the commands
 * and answers.
 *
 * @param sketch  an .elf or .hex file
 * @return false if the sketch has crashed or ended, or cannot be loaded. A message is on stderr or standard output
 */
bool stepped_run(const char *sketch);

#endif
