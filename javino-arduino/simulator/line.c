#include "line.h"

#include "rate.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

static bool fail(const char *what)
{
    fprintf(stderr, "simulator: %s: %s\n", what, strerror(errno));
    return false;
}

/* Returns true if the link points to this pseudo-terminal. */
static bool leads_to(const char *link, const char *path)
{
    char target[sizeof((line *)0)->path];
    ssize_t length = readlink(link, target, sizeof target);
    return length == (ssize_t)strlen(path) && memcmp(target, path, (size_t)length) == 0;
}

/* Makes a link. Replaces an old link that points nowhere or to this pseudo-terminal: a killed simulator has left it. */
static bool make_link(const char *path, const char *link)
{
    struct stat there;
    bool is_left = stat(link, &there) != 0 || leads_to(link, path);
    if (lstat(link, &there) == 0 && !(S_ISLNK(there.st_mode) && is_left)) {
        fprintf(stderr, "simulator: %s exists already, maybe as the port of another simulated board; end that, "
                        "give another path with --link, or remove it\n", link);
        return false;
    }
    unlink(link);
    return symlink(path, link) == 0 || fail(link);
}

bool line_open(line *line, const char *link)
{
    struct termios settings;
    memset(line, 0, sizeof *line);
    line->master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK);
    if (line->master < 0 || grantpt(line->master) != 0 || unlockpt(line->master) != 0 ||
        ptsname_r(line->master, line->path, sizeof line->path) != 0)
        return fail("no pseudo-terminal");
    line->slave = open(line->path, O_RDWR | O_NOCTTY);
    if (line->slave < 0 || tcgetattr(line->slave, &settings) != 0)
        return fail(line->path);
    cfmakeraw(&settings);
    tcsetattr(line->slave, TCSANOW, &settings);
    rate_forget(line->slave);
    line->opens = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (line->opens < 0 || inotify_add_watch(line->opens, line->path, IN_OPEN | IN_CLOSE) < 0)
        return fail("cannot watch the pseudo-terminal");
    if (link && !make_link(line->path, link))
        return false;
    line->link = link;
    return true;
}

bool line_opened(line *line)
{
    char buffer[4096] __attribute__((aligned(__alignof__(struct inotify_event))));
    bool opened = false;
    ssize_t got;
    while ((got = read(line->opens, buffer, sizeof buffer)) > 0) {
        char *at = buffer;
        while (at < buffer + got) {
            const struct inotify_event *event = (const struct inotify_event *)at;
            if (event->mask & IN_OPEN) {
                /* Drops bytes that the board sent for the previous program. */
                if (line->users++ == 0)
                    tcflush(line->slave, TCIFLUSH);
                opened = true;
            } else if (event->mask & IN_CLOSE && line->users > 0 && --line->users == 0) {
                rate_forget(line->slave); /* The next program may set no rate. */
            }
            at += sizeof *event + event->len;
        }
    }
    return opened;
}

size_t line_read(line *line, uint8_t *bytes, size_t size, unsigned baud)
{
    ssize_t got = read(line->master, bytes, size);
    unsigned far = got > 0 ? rate_of(line->slave) : 0;
    ssize_t i;
    for (i = 0; i < got; i++)
        bytes[i] = rate_sampled(bytes[i], far, baud);
    return got > 0 ? (size_t)got : 0;
}

void line_write(line *line, uint8_t byte, unsigned baud)
{
    byte = rate_sampled(byte, baud, rate_of(line->slave));
    if (line->users > 0 && write(line->master, &byte, 1) != 1 && errno != EAGAIN)
        fail("writing to the pseudo-terminal");
}

void line_close(line *line)
{
    if (line->link && leads_to(line->link, line->path))
        unlink(line->link);
    close(line->opens);
    close(line->slave);
    close(line->master);
}
