#include "panel.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/ioctl.h>
#include <unistd.h>

#define FIRST_ANALOGUE 14
#define SHOWN (BOARD_PINS + 2)
#define STEPS 1023
#define MILLIVOLTS 5000
#define USUAL_WIDTH 80

static const char HELP[] =
    "set inputs: 7=1 a level, A0=512 an analogue value of 0-1023, 8=30cm the echo of an HC-SR04 (8=0cm: nothing in sight);\n"
    "several at once with blanks between them; reset presses the button, quit ends";

/* ---- Output ---- */

static void name_of(int pin, char *name, size_t size)
{
    if (pin >= FIRST_ANALOGUE)
        snprintf(name, size, "A%d", pin - FIRST_ANALOGUE);
    else
        snprintf(name, size, "%d", pin);
}

/* Returns the lowest voltage that the converter turns into this value. */
static int millivolts_of(int value)
{
    return (value * MILLIVOLTS + STEPS - 1) / STEPS;
}

static int value_of(int millivolts)
{
    return millivolts * STEPS / MILLIVOLTS;
}

static bool is_digital_input(const panel *p, int pin)
{
    return p->board->levels[pin] || board_pulls_up(p->board, pin);
}

/* Writes the state of a pin in words. Writes an empty text if neither the sketch nor a person uses the pin. */
static void describe(const panel *p, int pin, char *text, size_t size)
{
    char name[8];
    const board *b = p->board;
    int input = pin - FIRST_ANALOGUE;
    pin_state state = {PIN_INPUT, 0};
    text[0] = 0;
    name_of(pin, name, sizeof name);
    if (pin < BOARD_PINS)
        state = board_state(b, pin);
    if (state.kind == PIN_PWM)
        snprintf(text, size, "%s out PWM %d", name, state.duty);
    else if (state.kind != PIN_INPUT)
        snprintf(text, size, "%s out %s", name, state.kind == PIN_HIGH ? "HIGH" : "low");
    else if (input >= 0 && (b->converted[input] || p->is_set[pin]))
        snprintf(text, size, "%s in %d", name, value_of(b->millivolts[input][0]));
    else if (pin < BOARD_PINS && p->sonar->pins[pin].is_echo)
        snprintf(text, size, "%s in %dcm", name, p->sonar->pins[pin].cm);
    else if (pin < BOARD_PINS && is_digital_input(p, pin))
        snprintf(text, size, "%s in %s", name, board_level(b, pin) ? "HIGH" : "low");
}

static size_t width(void)
{
    struct winsize size;
    return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : USUAL_WIDTH;
}

/* Draws one line: as many pins as fit, then the typed text. */
static void draw(panel *p)
{
    char line[sizeof p->line] = "";
    size_t room = width();
    size_t used = 0;
    int pin;
    room = room < sizeof line ? room : sizeof line;
    room = room > p->typed_length + 8 ? room - p->typed_length - 8 : 0;
    for (pin = 0; pin < SHOWN; pin++) {
        size_t length = strlen(p->shown[pin]);
        if (!length)
            continue;
        if (used + length + 3 > room) {
            strcat(line, " ...");
            break;
        }
        used += (size_t)sprintf(line + used, "%s%s", used ? " | " : "", p->shown[pin]);
    }
    if (!used)
        strcat(line, "no pin is in use yet");
    sprintf(line + strlen(line), " > %s", p->typed);
    if (strcmp(line, p->line) == 0)
        return;
    strcpy(p->line, line);
    printf("\r\033[K%s", line);
    fflush(stdout);
}

/* Prints text above the redrawn line. */
static void announce(panel *p, const char *text)
{
    printf(p->is_drawn ? "\r\033[K%s\n" : "%s\n", text);
    p->line[0] = 0;
    fflush(stdout);
}

void panel_look(panel *p)
{
    int pin;
    for (pin = 0; pin < SHOWN; pin++) {
        char text[sizeof p->shown[pin]];
        char name[8];
        describe(p, pin, text, sizeof text);
        if (strcmp(text, p->shown[pin]) == 0)
            continue;
        strcpy(p->shown[pin], text);
        if (p->is_drawn)
            continue;
        name_of(pin, name, sizeof name);
        printf("%9.3f s  %s%s\n", board_ms(p->board) / 1000, text[0] ? text : name, text[0] ? "" : " not in use");
    }
    if (p->is_drawn)
        draw(p);
    fflush(stdout);
}

/* ---- Input ---- */

/* A6 and A7 get the numbers after the pins, because an ATmega328P in DIP has no such pins. */
static int pin_of(const char *name)
{
    if (strcasecmp(name, "A6") == 0 || strcasecmp(name, "A7") == 0)
        return FIRST_ANALOGUE + name[1] - '0';
    return board_pin(name);
}

static bool refuse(panel *p, const char *what, const char *why)
{
    char text[256];
    snprintf(text, sizeof text, "%.100s: %s", what, why);
    announce(p, text);
    return false;
}

static bool set_number(panel *p, const char *setting, int pin, long number, const char *unit)
{
    if (strcasecmp(unit, "cm") == 0) {
        if (pin >= BOARD_PINS || number < 0 || number > SONAR_MAX_CM)
            return refuse(p, setting, "an HC-SR04 measures up to 400 cm; 0cm is nothing in sight");
        sonar_set(p->sonar, pin, (int)number);
        return true;
    }
    if (*unit)
        return refuse(p, setting, "a value is a number, a distance such as 30cm, high or low");
    if (pin < FIRST_ANALOGUE) {
        if (number < 0 || number > 1)
            return refuse(p, setting, "a level is 0 or 1; only A0 to A7 take other values");
        board_set_level(p->board, pin, number == 1);
        return true;
    }
    if (number < 0 || number > STEPS)
        return refuse(p, setting, "an analogue value is from 0 to 1023");
    board_set_millivolts(p->board, pin - FIRST_ANALOGUE, 0, (uint16_t)millivolts_of((int)number));
    return true;
}

/* Sets an input from a setting such as 7=1. */
static void set(panel *p, char *setting)
{
    char whole[64];
    char *value = strchr(setting, '=');
    char *unit;
    long number;
    int pin;
    bool high;
    snprintf(whole, sizeof whole, "%s", setting);
    *value++ = 0;
    pin = pin_of(setting);
    number = strtol(value, &unit, 10);
    high = strcasecmp(value, "high") == 0;
    if (pin < 0)
        refuse(p, whole, "there is no such pin; there are 0 to 13 and A0 to A7");
    else if ((high || strcasecmp(value, "low") == 0) && pin < BOARD_PINS) {
        board_set_level(p->board, pin, high);
        p->is_set[pin] = true;
    } else if (unit == value)
        refuse(p, whole, "a value is a number, a distance such as 30cm, high or low");
    else if (set_number(p, whole, pin, number, unit))
        p->is_set[pin] = true;
}

/* Returns false if the person has quit. */
static bool carry_out(panel *p, char *line)
{
    char *rest = NULL;
    char *word;
    for (word = strtok_r(line, " \t\r,;", &rest); word; word = strtok_r(NULL, " \t\r,;", &rest)) {
        if (strcmp(word, "quit") == 0 || strcmp(word, "q") == 0)
            return false;
        if (strcmp(word, "reset") == 0)
            board_reset(p->board);
        else if (strchr(word, '='))
            set(p, word);
        else
            announce(p, HELP);
    }
    return true;
}

static void erase(panel *p)
{
    if (p->typed_length)
        p->typed[--p->typed_length] = 0;
}

bool panel_type(panel *p, const char *bytes, size_t count)
{
    size_t i;
    for (i = 0; i < count; i++) {
        char c = bytes[i];
        if (c == '\n') {
            bool goes_on = carry_out(p, p->typed);
            p->typed_length = 0;
            p->typed[0] = 0;
            if (!goes_on)
                return false;
        } else if (c == 0x7F || c == '\b')
            erase(p);
        else if (c == 0x04 && p->is_typed && !p->typed_length)
            return false;
        else if (isprint((unsigned char)c) && p->typed_length < sizeof p->typed - 1) {
            p->typed[p->typed_length++] = c;
            p->typed[p->typed_length] = 0;
        }
    }
    panel_look(p);
    return true;
}

/* ---- Beginning and end ---- */

static bool is_capable(void)
{
    const char *kind = getenv("TERM");
    return kind && strcmp(kind, "dumb") != 0;
}

/* Lets the terminal deliver each key at once, without showing it. Ctrl-C still sends a signal. */
static bool take_keys(struct termios *before)
{
    struct termios keys;
    if (!isatty(STDIN_FILENO) || tcgetpgrp(STDIN_FILENO) != getpgrp() || tcgetattr(STDIN_FILENO, before) != 0)
        return false;
    keys = *before;
    keys.c_lflag &= ~(tcflag_t)(ICANON | ECHO);
    return tcsetattr(STDIN_FILENO, TCSANOW, &keys) == 0;
}

void panel_open(panel *p, board *board, sonar *sonar, const char *port)
{
    memset(p, 0, sizeof *p);
    p->board = board;
    p->sonar = sonar;
    p->is_drawn = isatty(STDOUT_FILENO) && is_capable();
    p->is_typed = take_keys(&p->keyboard);
    printf("port %s\nin an agent: argo.port(\"%s\"); at the console: ./argo tools monitor %s\n%s\n", port, port, port, HELP);
    fflush(stdout);
}

void panel_close(panel *p)
{
    if (p->is_typed)
        tcsetattr(STDIN_FILENO, TCSANOW, &p->keyboard);
    if (p->is_drawn)
        printf("\n");
}
