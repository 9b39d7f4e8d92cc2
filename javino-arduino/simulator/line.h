/** @file The board's serial line as a pseudo-terminal. */
#ifndef LINE_H
#define LINE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** The board's end of the line. */
typedef struct {
    int master;      /**< A descriptor for poll(), readable when the far end has written. */
    int opens;       /**< A descriptor for poll(), readable when somebody has opened or closed the far end. */
    int slave;       /* held open, so that the terminal's settings stay raw */
    int users;       /* how many programs have the far end open */
    char path[64];   /**< The far end's device. */
    const char *link; /* a symbolic link to the device, or null */
} line;

/**
 * Opens a line.
 *
 * @param link  the place for a symbolic link to the far end, which replaces a link that is there; may be null
 * @return false, with a message on stderr, if no pseudo-terminal can be had
 */
bool line_open(line *line, const char *link);

/** Notes which programs have opened and closed the far end. @return true if one has just opened it */
bool line_opened(line *line);

/**
 * Reads the bytes that the far end has written, as the board receives them: other bytes, if a program has set another rate there.
 *
 * @param baud  the board's rate; 0: the rate of the far end
 * @return the number of bytes, at most size
 */
size_t line_read(line *line, uint8_t *bytes, size_t size, unsigned baud);

/**
 * Puts one byte on the line, at the board's rate. If nobody has the far end open, or nobody reads, it is lost, as on a wire; a program that
 * has set another rate gets another byte.
 */
void line_write(line *line, uint8_t byte, unsigned baud);

/** Closes the line and removes the link. */
void line_close(line *line);

#endif
