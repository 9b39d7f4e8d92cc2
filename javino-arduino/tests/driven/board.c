/* A board with a small program, driven over standard input by differential.py, which explains the records. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "javino_board.h"

#define MEMORY 8192

static uint8_t memory[MEMORY];
static javino_board board;
static javino_later later;
static uint16_t now;
static char percepts[4096]; /* texts without their `;`, each with a zero byte behind */
static size_t percepts_length;

/* The output since the last answer. */
static uint8_t out[1 << 20];
static uint8_t carried[1 << 16];
static uint32_t out_length, carried_length;

static const javino_action actions[] = {{"say", JAVINO_ANY}, {"grip", 0}, {"bump", 0}, {"speed", 1}, {"left", 0}, {"front", 0}};

static void write_byte(void *context, uint8_t byte)
{
    (void)context;
    if (out_length == sizeof out)
        abort();
    out[out_length++] = byte;
}

static bool is(const char *text, uint8_t length, const char *other)
{
    return length == strlen(other) && memcmp(text, other, length) == 0;
}

/* The program: it knows whole texts. */
static void act(void)
{
    const char *text = board.link.text;
    uint8_t length = board.link.length;
    bool does = is(text, length, "front") || is(text, length, "left") || is(text, length, "grip") || is(text, length, "say") ||
                (length > 6 && memcmp(text, "speed(", 6) == 0);
    if (!does) {
        javino_link_finish(&board.link, false);
        return;
    }
    if (carried_length + length + 1 > sizeof carried)
        abort();
    carried[carried_length] = length;
    memcpy(carried + carried_length + 1, text, length);
    carried_length += length + 1u;
    if (is(text, length, "grip"))
        later = javino_link_later(&board.link);
}

static void answer(void)
{
    const char *p;
    for (p = percepts; p < percepts + percepts_length; p += strlen(p) + 1) {
        size_t functor = strcspn(p, "(");
        if (javino_board_wants(&board, p, (uint8_t)functor)) {
            javino_percept_text(&board, p);
            javino_percept_end(&board);
        }
    }
    javino_board_answer(&board);
}

static void poll(void)
{
    javino_event event;
    int quiet = 0;
    /* A poll handles only some frames, and then hands nothing out. */
    while (quiet < 3) {
        event = javino_board_poll(&board, now);
        quiet = event == JAVINO_NOTHING ? quiet + 1 : 0;
        if (event == JAVINO_REQUEST)
            answer();
        else if (event == JAVINO_ACTION)
            act();
    }
}

static void receive(const uint8_t *bytes, size_t length)
{
    javino_decoder_idle(&board.link.decoder, now);
    poll();
    while (length--) {
        if (!javino_link_ready(&board.link))
            abort();
        javino_link_receive(&board.link, *bytes++, now);
        poll();
    }
}

static void begin(void)
{
    if (!javino_board_init(&board, memory, sizeof memory, write_byte, NULL))
        abort();
    board.link.actions = actions;
    board.link.action_size = sizeof *actions;
    board.link.action_count = sizeof actions / sizeof *actions;
    later = 0;
    percepts_length = 0;
}

static void reply(void)
{
    fwrite(&out_length, 4, 1, stdout);
    fwrite(out, 1, out_length, stdout);
    fwrite(&carried_length, 4, 1, stdout);
    fwrite(carried, 1, carried_length, stdout);
    fflush(stdout);
    out_length = carried_length = 0;
}

int main(void)
{
    struct {
        char what;
        uint8_t flag;
        uint16_t now;
        uint16_t length;
    } record;
    static uint8_t bytes[65536];
    while (fread(&record, sizeof record, 1, stdin) == 1) {
        if (record.length && fread(bytes, record.length, 1, stdin) != 1)
            return 1;
        now = record.now;
        if (record.what == 'n') {
            begin();
        } else if (record.what == 'b') {
            receive(bytes, record.length);
        } else if (record.what == 'p') {
            if (record.length > sizeof percepts)
                abort();
            memcpy(percepts, bytes, record.length);
            percepts_length = record.length;
        } else if (record.what == 'u') {
            answer();
        } else if (record.what == 'd') {
            javino_link_done(&board.link, later, record.flag);
        } else {
            return 1;
        }
        reply();
    }
    return 0;
}
