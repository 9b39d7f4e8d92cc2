#include "stepped.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "board.h"
#include "console.h"

static void byte_sent(void *context, uint8_t byte, uint64_t cycle)
{
    (void)context;
    printf("byte %" PRIu64 " %02x\n", cycle, byte);
}

static bool send(board *board, const char *command)
{
    uint64_t cycle;
    uint64_t period;
    unsigned byte;
    int at = 0;
    bool is_read = sscanf(command, "send %" SCNu64 " %" SCNu64 " %n", &cycle, &period, &at) == 2;
    size_t digits = strspn(command + at, "0123456789abcdefABCDEF");
    if (!is_read || !digits || digits % 2 || command[at + digits]) {
        printf("error: send takes a cycle, the cycles of a byte and bytes in hexadecimal: %s\n", command);
        return false;
    }
    for (; sscanf(command + at, "%2x", &byte) == 1; at += 2, cycle += period) {
        if (board_room(board) == 0) {
            printf("error: the line holds no more bytes: %s\n", command + at);
            return false;
        }
        board_receive_at(board, (uint8_t)byte, cycle);
    }
    return true;
}

/* Carries out a run command. Returns false if the sketch has ended. */
static bool run(board *board, const char *command)
{
    uint64_t cycle;
    if (sscanf(command, "run %" SCNu64, &cycle) != 1) {
        printf("error: run takes the cycle to run to: %s\n", command);
        return true;
    }
    if (!board_run(board, cycle)) {
        printf("error: the sketch has crashed or gone to sleep for ever at %.3f ms\n", board_ms(board));
        return false;
    }
    printf("ok %" PRIu64 "\n", (uint64_t)board->avr->cycle);
    return true;
}

static bool carry_out(board *board, sonar *sonar, char *command, bool *runs)
{
    if (strncmp(command, "run ", 4) == 0)
        return *runs = run(board, command);
    if (strncmp(command, "send ", 5) != 0)
        return console_do(board, sonar, command);
    if (send(board, command))
        printf("ok\n");
    return true;
}

bool stepped_run(const char *sketch)
{
    static board board;
    static sonar sonar;
    static char command[16384]; /* large enough for a send command with all bytes that the line holds */
    bool runs = true;
    if (!board_load(&board, sketch, console_pin, NULL, NULL))
        return false;
    sonar_connect(&sonar, &board);
    board_foretell(&board, byte_sent);
    while (fgets(command, sizeof command, stdin)) {
        command[strcspn(command, "\r\n")] = 0;
        if (!carry_out(&board, &sonar, command, &runs))
            break;
        fflush(stdout);
    }
    fflush(stdout);
    return runs;
}
