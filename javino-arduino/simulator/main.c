/**
 * @file Runs an Arduino sketch on a simulated ATmega328P in real time. A pseudo-terminal replaces the serial line. README.md describes
 *     usage and commands.
 */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "board.h"
#include "console.h"
#include "line.h"
#include "panel.h"
#include "soft.h"
#include "stepped.h"

#define SLICE_NS 250000ull
/* The simulator catches up with delays up to this length. The simulator skips longer delays. */
#define LAG_NS 50000000ull
/* The time between two checks of the pins for the panel. */
#define PANEL_NS 100000000ull

static const char USAGE[] =
    "usage: simulator [--link PATH] [--soft RX,TX,BAUD] [--reset-on-open] [--boot-ms N] [--detached] [--panel] SKETCH.elf|SKETCH.hex\n"
    "       simulator --stepped SKETCH.elf|SKETCH.hex\n"
    "  --link PATH      a symbolic link to the serial line\n"
    "  --soft RX,TX,BAUD\n"
    "                   a second line, on these pins of the board, for a SoftwareSerial\n"
    "  --reset-on-open  opening the line resets the board, as on an Uno\n"
    "  --boot-ms N      after power-on and reset, the boot loader keeps the line for N ms\n"
    "  --detached       go on when standard input ends\n"
    "  --panel          for a person: shows the pins that are in use, and takes settings of inputs such as A0=512\n"
    "  --stepped        no line and no real time: commands on standard input advance the board, see README.md\n";

typedef struct {
    const char *link;
    const char *sketch;
    int soft_receives; /* -1 if there is no second line */
    int soft_sends;
    unsigned soft_baud;
    bool reset_on_open;
    bool detached;
    bool panel;
    uint64_t boot_cycles;
} options;

typedef struct {
    options options;
    board board;
    line line;
    line soft_line;
    soft soft;
    uint64_t offset_ns;   /* real time of power-on, plus all skipped delays */
    uint64_t boots_until_ns;
    char command[256];
    size_t command_length;
    panel panel;
    sonar sonar;
    uint64_t panel_at_ns;
} simulator;

static volatile sig_atomic_t ended;

static void end(int signal)
{
    (void)signal;
    ended = 1;
}

static uint64_t now_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (uint64_t)now.tv_sec * 1000000000ull + (uint64_t)now.tv_nsec;
}

static bool read_soft(options *o, const char *text)
{
    char receives[8];
    char sends[8];
    char extra;
    if (sscanf(text, "%7[^,],%7[^,],%u%c", receives, sends, &o->soft_baud, &extra) != 3)
        return false;
    o->soft_receives = board_pin(receives);
    o->soft_sends = board_pin(sends);
    return o->soft_receives >= 0 && o->soft_sends >= 0 && o->soft_receives != o->soft_sends && o->soft_baud >= 300 &&
           o->soft_baud <= 115200;
}

static bool read_options(options *o, int count, char **words)
{
    int i;
    memset(o, 0, sizeof *o);
    o->soft_receives = -1;
    for (i = 1; i < count; i++) {
        if (strcmp(words[i], "--link") == 0 && i + 1 < count)
            o->link = words[++i];
        else if (strcmp(words[i], "--boot-ms") == 0 && i + 1 < count) {
            char *end;
            o->boot_cycles = strtoull(words[++i], &end, 10) * (BOARD_HZ / 1000);
            if (*end || end == words[i])
                return false;
        } else if (strcmp(words[i], "--soft") == 0 && i + 1 < count) {
            if (!read_soft(o, words[++i]))
                return false;
        } else if (strcmp(words[i], "--reset-on-open") == 0)
            o->reset_on_open = true;
        else if (strcmp(words[i], "--detached") == 0)
            o->detached = true;
        else if (strcmp(words[i], "--panel") == 0)
            o->panel = true;
        else if (words[i][0] != '-' && !o->sketch)
            o->sketch = words[i];
        else
            return false;
    }
    return o->sketch != NULL;
}

static void byte_sent(void *context, uint8_t byte)
{
    simulator *s = (simulator *)context;
    line_write(&s->line, byte, board_baud(&s->board));
}

static void soft_byte_sent(void *context, uint8_t byte)
{
    simulator *s = (simulator *)context;
    line_write(&s->soft_line, byte, s->options.soft_baud);
}

/* Starts the time of the boot loader. Bytes that arrive in this time are dropped. */
static void boot(simulator *s)
{
    if (s->options.boot_cycles)
        s->boots_until_ns = now_ns() + s->options.boot_cycles * 1000000000ull / BOARD_HZ;
}

static bool booting(simulator *s)
{
    uint8_t lost[256];
    uint64_t now = now_ns();
    if (s->boots_until_ns == 0)
        return false;
    while (line_read(&s->line, lost, sizeof lost, 0) > 0) {
    }
    if (now < s->boots_until_ns)
        return true;
    s->boots_until_ns = 0;
    s->offset_ns = now - s->board.avr->cycle * 1000 / (BOARD_HZ / 1000000);
    return false;
}

/* Runs the sketch up to the present time. Returns false if the sketch has ended. */
static bool advance(simulator *s)
{
    uint64_t now = now_ns();
    uint64_t passed = now - s->offset_ns;
    uint64_t simulated = s->board.avr->cycle * 1000 / (BOARD_HZ / 1000000);
    if (passed > simulated + LAG_NS) {
        s->offset_ns = now - simulated - SLICE_NS;
        passed = simulated + SLICE_NS;
    }
    return board_run(&s->board, passed * (BOARD_HZ / 1000000) / 1000);
}

static void take_bytes(simulator *s)
{
    uint8_t bytes[256];
    size_t count = line_read(&s->line, bytes, sizeof bytes, board_baud(&s->board));
    size_t i;
    for (i = 0; i < count; i++)
        board_receive(&s->board, bytes[i]);
}

static void take_soft_bytes(simulator *s)
{
    uint8_t bytes[256];
    size_t count = line_read(&s->soft_line, bytes, sizeof bytes, s->options.soft_baud);
    size_t i;
    for (i = 0; i < count; i++)
        soft_receive(&s->soft, bytes[i]);
}

/* Takes a byte of a command. Returns true if the byte ends the command. Replaces a command that is too long by an empty one. */
static bool end_command(simulator *s, char byte)
{
    if (byte != '\n') {
        if (s->command_length < sizeof s->command)
            s->command[s->command_length++] = byte;
        return false;
    }
    if (s->command_length == sizeof s->command) {
        printf("error: a command has fewer than %zu characters\n", sizeof s->command);
        s->command_length = 0;
    }
    s->command[s->command_length] = 0;
    s->command_length = 0;
    return true;
}

/* Takes the commands that have arrived. Returns false after quit, or if standard input has ended. */
static bool take_commands(simulator *s)
{
    char bytes[256];
    ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
    ssize_t i;
    if (count == 0 || (count < 0 && errno != EAGAIN && errno != EINTR))
        return false;
    if (s->options.panel)
        return count < 0 || panel_type(&s->panel, bytes, (size_t)count);
    for (i = 0; i < count; i++)
        if (end_command(s, bytes[i]) && !console_do(&s->board, &s->sonar, s->command))
            return false;
    return true;
}

static void show(simulator *s)
{
    uint64_t now = now_ns();
    if (!s->options.panel || now < s->panel_at_ns)
        return;
    s->panel_at_ns = now + PANEL_NS;
    panel_look(&s->panel);
}

/* Waits at most SLICE_NS for something to do. Returns false if the simulator must end. */
static bool wait_for_work(simulator *s, bool *has_input)
{
    struct pollfd sources[] = {{s->line.master, POLLIN, 0}, {s->line.opens, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0},
                               {-1, POLLIN, 0}, {-1, POLLIN, 0}};
    struct timespec slice = {0, (long)SLICE_NS};
    int ready;
    /* Bytes wait in the terminal while the board has no room. */
    if (board_room(&s->board) < 256)
        sources[0].fd = -1;
    if (!*has_input)
        sources[2].fd = -1;
    if (s->options.soft_receives >= 0) {
        sources[3].fd = s->soft_line.opens;
        if (soft_room(&s->soft) >= 256)
            sources[4].fd = s->soft_line.master;
    }
    ready = ppoll(sources, 5, &slice, NULL);
    if (ready <= 0)
        return true;
    if (sources[1].revents && line_opened(&s->line) && s->options.reset_on_open) {
        board_reset(&s->board);
        boot(s);
    }
    if (sources[0].revents & POLLIN && !booting(s))
        take_bytes(s);
    if (sources[3].revents)
        line_opened(&s->soft_line);
    if (sources[4].revents & POLLIN)
        take_soft_bytes(s);
    if (sources[2].revents && !take_commands(s)) {
        *has_input = false;
        return s->options.detached;
    }
    return true;
}

static bool open_soft(simulator *s)
{
    const options *o = &s->options;
    soft_connect(&s->soft, &s->board, o->soft_receives, o->soft_sends, o->soft_baud, soft_byte_sent, s);
    return line_open(&s->soft_line, NULL);
}

int main(int count, char **words)
{
    static simulator s;
    bool has_input = true;
    bool runs = true;
    if (count == 3 && strcmp(words[1], "--stepped") == 0)
        return stepped_run(words[2]) ? 0 : 1;
    if (!read_options(&s.options, count, words)) {
        fputs(USAGE, stderr);
        return 2;
    }
    if (!board_load(&s.board, s.options.sketch, console_pin, byte_sent, &s) || !line_open(&s.line, s.options.link))
        return 1;
    sonar_connect(&s.sonar, &s.board);
    if (s.options.soft_receives >= 0 && !open_soft(&s))
        return 1;
    signal(SIGINT, end);
    signal(SIGTERM, end);
    signal(SIGPIPE, SIG_IGN);
    setvbuf(stdout, NULL, _IOLBF, 0);
    if (s.options.panel)
        panel_open(&s.panel, &s.board, &s.sonar, s.options.link ? s.options.link : s.line.path);
    else
        printf("port %s\n", s.options.link ? s.options.link : s.line.path);
    if (s.options.soft_receives >= 0)
        printf("second port %s\n", s.soft_line.path);
    s.offset_ns = now_ns();
    boot(&s);
    while (runs && !ended && wait_for_work(&s, &has_input)) {
        runs = booting(&s) || advance(&s);
        show(&s);
    }
    line_close(&s.line);
    if (s.options.soft_receives >= 0)
        line_close(&s.soft_line);
    if (s.options.panel)
        panel_close(&s.panel);
    if (!runs)
        fprintf(stderr, "simulator: the sketch has crashed or gone to sleep for ever, %.3f ms after power-on\n",
                board_ms(&s.board));
    return runs ? 0 : 1;
}
