/** @file Shows the board's pins to a person. The person sets inputs on the keyboard. */
#ifndef PANEL_H
#define PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <termios.h>

#include "board.h"
#include "sonar.h"

/** The members are private. */
typedef struct {
    board *board;
    sonar *sonar;
    bool is_drawn;                   /* whether output is a terminal whose line can be redrawn */
    bool is_typed;                   /* whether the keyboard's settings are changed */
    struct termios keyboard;         /* the keyboard's settings before panel_open */
    bool is_set[BOARD_PINS + 2];     /* pins that the person has set; A6 and A7 come last */
    char shown[BOARD_PINS + 2][32];
    char line[512];                  /* the last drawn line */
    char typed[128];
    size_t typed_length;
} panel;

/** Prints the port's name and help for inputs, and begins to show the pins of a board. `sonar` belongs to this board. */
void panel_open(panel *panel, board *board, sonar *sonar, const char *port);

/** Shows changes. Call this about ten times a second. */
void panel_look(panel *panel);

/** Takes typed bytes, and carries out each typed line. @return false if the person has quit */
bool panel_type(panel *panel, const char *bytes, size_t count);

void panel_close(panel *panel);

#endif
