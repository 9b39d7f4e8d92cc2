#include "console.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WORDS 8

void console_pin(void *context, int pin, pin_state state, double ms)
{
    static const char *const NAMES[] = {"input", "low", "high", "pwm"};
    (void)context;
    printf("pin %d %s", pin, NAMES[state.kind]);
    if (state.kind == PIN_PWM)
        printf(" %d", state.duty);
    printf(" %.3f\n", ms);
}

static bool say_error(const char *what, const char *found)
{
    printf("error: %s: %s\n", what, found ? found : "nothing");
    return true;
}

/* Reads an analogue input such as A0, or a channel of a multiplexer such as A4.2. */
static bool analogue(const char *name, int *input, int *channel)
{
    char extra;
    *channel = 0;
    if (sscanf(name, "A%d.%d%c", input, channel, &extra) != 2 && sscanf(name, "A%d%c", input, &extra) != 1)
        return false;
    return *input >= 0 && *input < BOARD_ANALOGUE && *channel >= 0 && *channel < BOARD_CHANNELS;
}

static bool set(board *board, const char *name, const char *value)
{
    int input;
    int channel;
    char *end;
    int pin = board_pin(name);
    bool high = strcmp(value, "high") == 0;
    if (high || strcmp(value, "low") == 0) {
        if (pin < 0)
            return say_error("there is no such pin", name);
        board_set_level(board, pin, high);
        printf("ok\n");
        return true;
    }
    if (!analogue(name, &input, &channel))
        return say_error("a voltage goes to A0-A7 or a channel such as A4.2, a pin takes high or low", name);
    unsigned long millivolts = strtoul(value, &end, 10);
    if (*end || end == value || millivolts > 5000)
        return say_error("a voltage is 0-5000 mV", value);
    board_set_millivolts(board, input, channel, (uint16_t)millivolts);
    printf("ok\n");
    return true;
}

static bool multiplex(board *board, char **words, int count)
{
    int pins[BOARD_SELECTS];
    int input;
    int channel;
    int i;
    if (!analogue(words[1], &input, &channel) || count < 3 || count > 2 + BOARD_SELECTS)
        return say_error("mux takes an analogue input and one to four select pins, the lowest bit first", words[1]);
    for (i = 2; i < count; i++)
        if ((pins[i - 2] = board_pin(words[i])) < 0)
            return say_error("there is no such pin", words[i]);
    board_multiplex(board, input, pins, count - 2);
    printf("ok\n");
    return true;
}

static bool measure(sonar *sonar, const char *name, const char *cm)
{
    int pin = board_pin(name);
    char *end;
    long number = strtol(cm, &end, 10);
    if (pin < 0)
        return say_error("there is no such pin", name);
    if (*end || end == cm || number < 0 || number > SONAR_MAX_CM)
        return say_error("a distance is 0-400 cm", cm);
    sonar_set(sonar, pin, (int)number);
    printf("ok\n");
    return true;
}

static int split(char *command, char **words)
{
    int count = 0;
    char *rest = NULL;
    char *word = strtok_r(command, " \t\r\n", &rest);
    for (; word && count < WORDS; word = strtok_r(NULL, " \t\r\n", &rest))
        words[count++] = word;
    return count;
}

bool console_do(board *board, sonar *sonar, char *command)
{
    char *words[WORDS] = {NULL};
    int count = split(command, words);
    int pin = count == 2 ? board_pin(words[1]) : -1;
    if (count == 0)
        return true;
    if (strcmp(words[0], "quit") == 0)
        return false;
    if (strcmp(words[0], "set") == 0 && count == 3)
        return set(board, words[1], words[2]);
    if (strcmp(words[0], "mux") == 0 && count > 1)
        return multiplex(board, words, count);
    if (strcmp(words[0], "sonar") == 0 && count == 3)
        return measure(sonar, words[1], words[2]);
    if (strcmp(words[0], "reset") == 0) {
        board_reset(board);
        printf("ok\n");
        return true;
    }
    if (strcmp(words[0], "time") == 0) {
        printf("ok %.3f\n", board_ms(board));
        return true;
    }
    if (strcmp(words[0], "get") != 0 && strcmp(words[0], "watch") != 0)
        return say_error("commands are set, get, watch, mux, sonar, time, reset and quit", words[0]);
    if (pin < 0)
        return say_error("there is no such pin", words[1]);
    if (strcmp(words[0], "get") == 0)
        console_pin(NULL, pin, board_state(board, pin), board_ms(board));
    else
        board_watch(board, pin);
    return true;
}
