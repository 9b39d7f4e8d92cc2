/** @file A board whose time advances only by commands. */
#ifndef STEPPED_H
#define STEPPED_H

#include <stdbool.h>

/**
 * Runs a sketch step by step. Commands come on standard input and answers go to standard output; README.md describes both.
 *
 * @param sketch  an .elf or .hex file
 * @return false if the sketch has crashed or ended, or cannot be loaded, which stderr reports
 */
bool stepped_run(const char *sketch);

#endif
