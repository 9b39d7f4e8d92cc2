/* Asks a board of its own for percepts and prints the answer. */
#include <stdio.h>

#include "javino_board.h"

static void print(void *context, uint8_t byte)
{
    (void)context;
    putchar(byte);
}

int main(void)
{
    static const char REQUEST[] = "fffe0BgetPercepts";
    static uint32_t memory[(JAVINO_MEMORY + JAVINO_MAX_PAYLOAD) / 4];
    static javino_board board;
    const char *byte;
    if (!javino_board_init(&board, memory, sizeof memory, print, NULL))
        return 1;
    for (byte = REQUEST; *byte; byte++)
        javino_link_receive(&board.link, (uint8_t)*byte, 0);
    if (javino_board_poll(&board, 0) != JAVINO_REQUEST || !javino_percept_begin(&board, "light"))
        return 1;
    javino_percept_text(&board, "(40)");
    javino_percept_end(&board);
    javino_board_answer(&board);
    return 0;
}
