/*
 * The board's library behind standard input and output, for comparison with another implementation. A line is an operation:
 *
 *   n             a new board
 *   N             a new board that holds rules
 *   w MS          nothing arrives for MS milliseconds
 *   b HEX         bytes arrive
 *   p HEX ...     the sensors show these percepts, each without its ;
 *   u             the percepts are sent unasked
 *   r 0|1         the outcome of the newest action that is open
 *   l             the board compares the percepts with its rules
 *
 * The program writes "> HEX" for bytes from the board, "! HEX" for a command that the board carries out, and "." after each operation. The
 * board refuses speed without arguments, and commands that begin with "no" or with the byte 01. A command that begins with "later" keeps
 * its outcome open.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "javino_board.h"
#include "javino_rules.h"

#define MEMORY 4096
#define MAX_PERCEPTS 64
#define MAX_LINE 65536

static javino_board board;
static uint8_t *memory;
static uint16_t now;
static javino_later later;
static char *percepts[MAX_PERCEPTS];
static int percept_count;
static bool writing;

static void end_bytes(void)
{
    if (writing)
        putchar('\n');
    writing = false;
}

static void write_byte(void *context, uint8_t byte)
{
    (void)context;
    if (!writing)
        printf("> ");
    writing = true;
    printf("%02x", byte);
}

static const javino_action actions[] = {{"say", JAVINO_ANY}, {"later", 0}, {"no", 0}, {"speed", 1}, {"front", 0}};

static bool begins(const javino_link *link, const char *text)
{
    return link->length >= strlen(text) && memcmp(link->text, text, strlen(text)) == 0;
}

static void print_command(const char *text, uint8_t length)
{
    end_bytes();
    printf("! ");
    while (length--)
        printf("%02x", (uint8_t)*text++);
    putchar('\n');
}

static bool act_on_reflex(void *context, const char *text, uint8_t length)
{
    (void)context;
    if (length >= 2 && memcmp(text, "no", 2) == 0)
        return false;
    print_command(text, length);
    return true;
}

static void act(void)
{
    javino_link *link = &board.link;
    if (begins(link, "no") || begins(link, "\1") || (begins(link, "speed") && link->length == 5)) {
        javino_link_finish(link, false);
        return;
    }
    print_command(link->text, link->length);
    if (begins(link, "later") && link->session)
        later = javino_link_later(link);
}

static void perceive(void *context)
{
    int i;
    (void)context;
    for (i = 0; i < percept_count; i++) {
        const char *p = percepts[i];
        const char *name = *p == '~' ? p + 1 : p;
        if (!javino_board_wants(&board, name, (uint8_t)strcspn(name, "(")))
            continue;
        javino_percept_text(&board, p);
        javino_percept_end(&board);
    }
}

static void show(void)
{
    perceive(NULL);
    javino_board_answer(&board);
}

static void run(void)
{
    javino_event event;
    while ((event = javino_board_poll(&board, now)) != JAVINO_NOTHING)
        if (event == JAVINO_REQUEST)
            show();
        else
            act();
}

static void start(void)
{
    free(memory);
    memory = malloc(MEMORY); /* a separate block, so the sanitizer sees accesses beyond it */
    if (!memory || !javino_board_init(&board, memory, MEMORY, write_byte, NULL))
        exit(1);
    board.link.actions = actions;
    board.link.action_size = sizeof *actions;
    board.link.action_count = sizeof actions / sizeof *actions;
    now = 0;
    later = 0;
    percept_count = 0;
}

static size_t unhex(char *text)
{
    size_t length = strlen(text) / 2;
    size_t i;
    for (i = 0; i < length; i++) {
        char digits[3] = {text[2 * i], text[2 * i + 1], 0};
        text[i] = (char)strtoul(digits, NULL, 16);
    }
    text[length] = 0;
    return length;
}

static void receive(char *hex)
{
    size_t length = unhex(hex);
    size_t i;
    for (i = 0; i < length; i++) {
        if (!javino_link_ready(&board.link))
            exit(2);
        javino_link_receive(&board.link, (uint8_t)hex[i], now);
        run();
    }
}

static void set_percepts(char *list)
{
    static char texts[MAX_LINE];
    char *p = strcpy(texts, list);
    percept_count = 0;
    for (p = strtok(p, " "); p; p = strtok(NULL, " ")) {
        unhex(p);
        percepts[percept_count++] = p;
    }
}

int main(void)
{
    static char line[MAX_LINE];
    while (fgets(line, sizeof line, stdin)) {
        char *argument = line + 2;
        line[strcspn(line, "\n")] = 0;
        switch (line[0]) {
        case 'n': start(); break;
        case 'N':
            start();
            if (!javino_rules_init(&board, 255, act_on_reflex, NULL))
                return 1;
            break;
        case 'l':
            now += JAVINO_RULES_MS;
            javino_rules_look(&board, perceive, now);
            break;
        case 'w': now += (uint16_t)atoi(argument); run(); break;
        case 'b': receive(argument); break;
        case 'p': set_percepts(argument); break;
        case 'u': show(); break;
        case 'r': javino_link_done(&board.link, later, argument[0] == '1'); break;
        default: return 3;
        }
        end_bytes();
        puts(".");
    }
    free(memory);
    return 0;
}
