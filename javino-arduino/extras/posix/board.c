/**
 * @file A board without Arduino: a complete program for a POSIX serial port. It prints a line of text in place of a lamp, and uses the
 *     clock in place of a sensor.
 *
 *     board DEVICE [BAUD]
 *
 *   actions   lampOn  lampOff  dim(0..100)
 *   percepts  lamp(Percent)  uptime(Seconds)
 *
 * On a microcontroller, replace open_port, now_ms, take_bytes and put_byte, and drop main's arguments.
 */
#define _DEFAULT_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "javino_board.h"
#include "javino_literal.h"

static uint8_t memory[JAVINO_MEMORY + JAVINO_MAX_PAYLOAD];
static javino_board board;
static int port;
static int32_t lamp;

static uint32_t now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint32_t)now.tv_sec * 1000u + (uint32_t)(now.tv_nsec / 1000000);
}

static speed_t speed_of(long baud)
{
    switch (baud) {
    case 9600: return B9600;
    case 19200: return B19200;
    case 38400: return B38400;
    case 57600: return B57600;
    case 115200: return B115200;
    default: return B0;
    }
}

static int open_port(const char *device, long baud)
{
    struct termios settings;
    int fd = open(device, O_RDWR | O_NOCTTY);
    if (fd < 0 || tcgetattr(fd, &settings) != 0) {
        fprintf(stderr, "board: %s: %s\n", device, strerror(errno));
        exit(1);
    }
    cfmakeraw(&settings);
    cfsetspeed(&settings, speed_of(baud));
    tcsetattr(fd, TCSANOW, &settings);
    return fd;
}

/* Takes arrived bytes while the link has room. Returns the time at the call's beginning. */
static uint32_t take_bytes(void)
{
    struct pollfd source = {port, POLLIN, 0};
    uint32_t now = now_ms();
    uint8_t byte;
    while (javino_link_ready(&board.link) && poll(&source, 1, 0) == 1) {
        if (read(port, &byte, 1) != 1) {
            fprintf(stderr, "board: the line is gone\n");
            exit(1);
        }
        javino_link_receive(&board.link, byte, (uint16_t)now);
    }
    return now;
}

/* Called by the core. On a microcontroller with a short receive buffer, also take received bytes here. */
static void put_byte(void *context, uint8_t byte)
{
    (void)context;
    while (write(port, &byte, 1) != 1) {
        if (errno != EINTR && errno != EAGAIN) {
            fprintf(stderr, "board: the line is gone: %s\n", strerror(errno));
            exit(1);
        }
    }
}

static void answer(void)
{
    if (javino_percept_begin(&board, "lamp")) {
        javino_percept_put(&board, '(');
        javino_percept_number(&board, (uint32_t)lamp, false);
        javino_percept_put(&board, ')');
        javino_percept_end(&board);
    }
    if (javino_percept_begin(&board, "uptime")) {
        javino_percept_put(&board, '(');
        javino_percept_number(&board, now_ms() / 1000, false);
        javino_percept_put(&board, ')');
        javino_percept_end(&board);
    }
    javino_board_answer(&board);
}

static const javino_action actions[] = {{"dim", 1}, {"lampOff", 0}, {"lampOn", 0}};

static bool is(const char *text, uint8_t length, const char *name)
{
    return strlen(name) == length && memcmp(text, name, length) == 0;
}

/* Carries out the present action. Returns false if the action is unknown or malformed. */
static bool act(const char *text, uint8_t length)
{
    const char *argument = text;
    int32_t wanted = -1;
    if (is(text, length, "lampOn")) {
        wanted = 100;
    } else if (is(text, length, "lampOff")) {
        wanted = 0;
    } else if (is(text, javino_functor(text, length), "dim")) {
        uint8_t n = javino_argument(text, length, 0, &argument);
        if (!javino_number(argument, n, &wanted))
            wanted = -1;
    }
    if (wanted < 0 || wanted > 100)
        return false;
    lamp = wanted;
    printf("lamp %d\n", (int)lamp);
    return true;
}

int main(int count, char **words)
{
    long baud = count > 2 ? strtol(words[2], NULL, 10) : 9600;
    if (count < 2 || speed_of(baud) == B0) {
        fprintf(stderr, "usage: board DEVICE [9600|19200|38400|57600|115200]\n");
        return 2;
    }
    setvbuf(stdout, NULL, _IOLBF, 0);
    port = open_port(words[1], baud);
    javino_board_init(&board, memory, sizeof memory, put_byte, NULL);
    board.link.actions = actions;
    board.link.action_size = sizeof *actions;
    board.link.action_count = sizeof actions / sizeof *actions;
    javino_link_timeout(&board.link, JAVINO_TIMEOUT_MS(baud));
    javino_link_supervise(&board.link, now_ms());
    for (;;) {
        struct pollfd source = {port, POLLIN, 0};
        uint32_t now;
        poll(&source, 1, 10);
        now = take_bytes();
        switch (javino_board_poll(&board, (uint16_t)now)) {
        case JAVINO_REQUEST:
            answer();
            break;
        case JAVINO_ACTION: {
            bool done = act(board.link.text, board.link.length);
            javino_link_finish(&board.link, done);
            break;
        }
        default:
            break;
        }
        if (javino_link_lost(&board.link, 1000, now) && lamp)
            printf("lamp %d: nobody is there\n", (int)(lamp = 0));
    }
}
