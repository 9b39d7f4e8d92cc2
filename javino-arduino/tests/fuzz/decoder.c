/* libFuzzer: any bytes, in any memory, with silences anywhere, through the whole conversation. */
#include <stdlib.h>
#include <string.h>

#include "javino_board.h"
#include "javino_literal.h"
#include "javino_rules.h"

static void discard(void *context, uint8_t byte)
{
    (void)context;
    (void)byte;
}

static const javino_action actions[] = {{"front", 0}, {"speed", 1}, {"", 2}};

static void read_action(const javino_link *link)
{
    const char *text = link->text;
    const char *argument;
    uint8_t i = 0;
    uint8_t n;
    if (!javino_functor(text, link->length))
        return;
    while ((n = javino_argument(text, link->length, i++, &argument)) != 0) {
        int32_t number;
        if (argument < text || argument + n > text + link->length)
            abort();
        javino_number(argument, n, &number);
    }
}

static void answer(javino_board *board, uint8_t seed)
{
    int i;
    for (i = 0; i < seed; i++)
        if (javino_percept_begin(board, i & 4 ? "dist" : "light")) {
            javino_percept_text(board, i & 8 ? "(front," : "(back,");
            javino_percept_number(board, (uint32_t)seed << (i & 15), i & 1);
            javino_percept_put(board, ')');
            javino_percept_end(board);
        }
    javino_board_answer(board);
}

/* The board is the context of the callbacks. */
static void perceive(void *context)
{
    javino_board *board = context;
    javino_percept_text(board, "dist(f,39)");
    javino_percept_end(board);
    if (javino_percept_begin(board, "light")) {
        javino_percept_text(board, "(-1.50,\"a,b\")");
        javino_percept_end(board);
    }
}

static bool react(void *context, const char *text, uint8_t length)
{
    javino_board *board = context;
    if (length && text[length - 1] == 'c')
        javino_board_clear(board);
    javino_percept_text(board, "reacted");
    return javino_percept_end(board);
}

typedef struct {
    javino_board *board;
    uint16_t now;
} line;

static void arrive(void *context, uint8_t byte)
{
    line *l = context;
    if (javino_link_ready(&l->board->link))
        javino_link_receive(&l->board->link, byte, l->now);
}

/* Makes an intact frame of version 2, which mere chance would not find. Returns the input bytes that it used. */
static size_t arrive_frame(javino_board *board, uint16_t now, const uint8_t *data, size_t size)
{
    static const uint8_t kinds[] = {JAVINO_HELLO, JAVINO_ASK, JAVINO_DESCRIBE, JAVINO_COMMANDS, JAVINO_RESUME};
    line l = {board, now};
    javino_encoder encoder = {arrive, &l, 0, false};
    size_t i;
    if (size < 3)
        return size;
    size = size - 3 < data[2] % 80u ? size - 3 : data[2] % 80u;
    javino_encoder_begin2(&encoder, (uint8_t)(data[1] % 16 ? board->link.session : data[1]), kinds[data[0] % 5], data[1], (uint8_t)size);
    for (i = 0; i < size; i++)
        javino_encoder_put(&encoder, data[3 + i]);
    javino_encoder_end(&encoder);
    return 3 + size;
}

/* The first byte chooses the memory. After that 0xFF is an escape: the next byte is a silence, in units of 2 ms. Behind 0xFE
 * stands an intact frame of version 2: kind, number, length, payload. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    javino_board board;
    javino_later later = 0;
    uint16_t now = 65000;
    size_t i;
    uint16_t bytes;
    uint8_t *memory;
    if (size == 0)
        return 0;
    bytes = (uint16_t)(JAVINO_MEMORY_MIN + 3 * data[0]);
    memory = malloc(bytes);
    javino_board_init(&board, memory, bytes, discard, &board);
    board.link.actions = actions;
    board.link.action_size = sizeof *actions;
    board.link.action_count = 3;
    if (data[0] & 1)
        javino_rules_init(&board, data[0] / 2, react, NULL);
    for (i = 1; i < size; i++) {
        javino_event event;
        if (data[i] == 0xFF && i + 1 < size) {
            now += 2 * data[++i];
        } else if (data[i] == 0xFE) {
            i += arrive_frame(&board, now, data + i + 1, size - i - 1);
        } else if (javino_link_ready(&board.link)) {
            javino_link_receive(&board.link, data[i], now);
        }
        if (data[i] & 1 && i % 3)
            continue; /* Bytes also come while the program is busy. */
        while ((event = javino_board_poll(&board, now)) != JAVINO_NOTHING) {
            if (event == JAVINO_REQUEST) {
                answer(&board, data[i]);
            } else {
                read_action(&board.link);
                if (data[i] & 2)
                    javino_link_finish(&board.link, false);
                else if (data[i] & 4)
                    later = javino_link_later(&board.link);
            }
        }
        javino_rules_look(&board, perceive, now);
        if (data[i] == 'd')
            javino_link_done(&board.link, later, i & 1);
        if (data[i] == 'p') {
            javino_percept_text(&board, "bumped(7)");
            javino_percept_end(&board);
        }
        if (data[i] == 'u')
            javino_board_answer(&board);
    }
    free(memory);
    return 0;
}
