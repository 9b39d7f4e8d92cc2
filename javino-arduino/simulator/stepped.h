/** @file A board whose time advances only when it is asked to. */
#ifndef STEPPED_H
#define STEPPED_H

#include <stdbool.h>

/**
 * Runs a sketch step by step: commands on standard input, answers on standard output, as README.md describes them.
 *
 * @param sketch  an .elf or .hex file
 * @return false with a message on stderr if the sketch cannot be loaded, or has crashed or ended
 */
bool stepped_run(const char *sketch);

#endif
