/* libFuzzer: any bytes, in any memory, with silences anywhere, through the whole conversation. */
#include <stdlib.h>
#include <string.h>

#include "javino_board.h"
#include "javino_literal.h"

static void discard(void *context, uint8_t byte)
{
    (void)context;
    (void)byte;
}

static void read_action(const javino_frame *frame)
{
    const char *text = (const char *)frame->payload;
    const char *argument;
    uint8_t i = 0;
    uint8_t n;
    if (!javino_functor(text, frame->length))
        return;
    while ((n = javino_argument(text, frame->length, i++, &argument)) != 0) {
        int32_t number;
        if (argument < text || argument + n > text + frame->length)
            abort();
        javino_number(argument, n, &number);
    }
}

static void answer(javino_board *board, const javino_frame *frame)
{
    int i;
    for (i = 0; i < frame->length; i++)
        if (javino_percept_begin(board, "dist")) {
            javino_percept_text(board, "(front,");
            javino_percept_number(board, frame->payload[i], i & 1);
            javino_percept_put(board, ')');
            javino_percept_end(board);
        }
    javino_board_answer(board);
}

/* The first byte chooses the memory. After that 0xFF is an escape: the next byte is a silence, in units of 2 ms. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    javino_board board;
    uint16_t now = 65000;
    size_t i;
    uint16_t bytes;
    uint8_t *memory;
    if (size == 0)
        return 0;
    bytes = (uint16_t)(JAVINO_MEMORY_MIN + 3 * data[0]);
    memory = malloc(bytes);
    javino_board_init(&board, memory, bytes, discard, NULL);
    for (i = 1; i < size; i++) {
        javino_event event;
        if (data[i] == 0xFF && i + 1 < size) {
            now += 2 * data[++i];
        } else if (javino_link_ready(&board.link)) {
            javino_link_receive(&board.link, data[i], now);
        }
        if (data[i] & 1 && i % 3)
            continue; /* Bytes also come while the program is busy. */
        while ((event = javino_board_poll(&board, now)) != JAVINO_NOTHING) {
            if (event == JAVINO_REQUEST)
                answer(&board, &board.link.frame);
            else
                read_action(&board.link.frame);
        }
    }
    free(memory);
    return 0;
}
