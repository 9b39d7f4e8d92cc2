/** @file Shows the board's pins to a person, who sets inputs by the keyboard. */
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
    bool is_drawn;                   /* true on a terminal, where the line is redrawn */
    bool is_typed;                   /* the keyboard's settings are changed */
    struct termios keyboard;         /* the keyboard's settings before */
    bool is_set[BOARD_PINS + 2];     /* pins set by a person; A6 and A7 are behind the others */
    char shown[BOARD_PINS + 2][32];
    char line[512];                  /* the line that was drawn last */
    char typed[128];
    size_t typed_length;
} panel;

/** Prints the port's name and how to set inputs, and begins to show the pins of a board. The sonar is connected to it. */
void panel_open(panel *panel, board *board, sonar *sonar, const char *port);

/** Shows changes. Meant to be called some ten times a second. */
void panel_look(panel *panel);

/** Takes typed bytes, and carries out each line of them. @return false if it was quit */
bool panel_type(panel *panel, const char *bytes, size_t count);

/** Restores the terminal's settings. */
void panel_close(panel *panel);

#endif
