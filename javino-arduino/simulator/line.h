/** @file The board's serial line as a pseudo-terminal. */
#ifndef LINE_H
#define LINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** The board's end of the line. */
typedef struct {
    int master;      /**< A descriptor for poll(). Readable when the far end has written. */
    int opens;       /**< A descriptor for poll(). Readable when a program has opened or closed the far end. */
    int slave;       /* kept open, so the terminal stays in raw mode */
    int users;       /* number of programs that have the far end open */
    char path[64];   /**< The far end's device. */
    const char *link; /* a symbolic link to the device, or null */
} line;

/**
 * Opens a line.
 *
 * @param link  path for a symbolic link to the far end, or null. A stale link at this path is replaced
 * @return false, with a message on stderr, if the line cannot be opened
 */
bool line_open(line *line, const char *link);

/** Records which programs have opened and closed the far end. @return true if a program has just opened the far end */
bool line_opened(line *line);

/**
 * Reads the bytes that the far end has written. If the far end has another rate, the board receives garbled bytes.
 *
 * @param baud  the board's rate; 0 for the rate of the far end
 * @return the number of bytes, at most size
 */
size_t line_read(line *line, uint8_t *bytes, size_t size, unsigned baud);

/**
 * Sends one byte on the line, at the board's rate. The byte is lost if nobody has the far end open or nobody reads. A program with
 * another rate receives a garbled byte.
 */
void line_write(line *line, uint8_t byte, unsigned baud);

/** Closes the line and removes the link. */
void line_close(line *line);

#endif
