/**
 * @file A board: a link, and the percepts that answer requests.
 *
 * An answer is text: percepts, each followed by `;`. The answer is built after the received bytes, in the link's memory. The board codes
 * the answer in place when it is sent, or earlier if the memory is full. In version 2, each digit of a percept takes half a byte if the
 * computer knows the rest of the percept. If an answer still does not fit, its beginning goes out early: in version 2 as a part of the
 * answer, in version 1 as messages of whole percepts. Unasked percepts leave JAVINO_WINDOW bytes of memory free, so the longest frame can
 * still arrive. In version 1 unasked percepts are one message of at most 255 bytes.
 */
#ifndef JAVINO_BOARD_H
#define JAVINO_BOARD_H

#include "javino_link.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes of a board's memory that are always reserved for an answer. */
#define JAVINO_TEXT_MIN 64
/** The memory, in bytes, with which a board can receive every frame. */
#define JAVINO_MEMORY (JAVINO_WINDOW + JAVINO_TEXT_MIN)
/** The smallest memory of a board, in bytes. */
#define JAVINO_MEMORY_MIN 160

/**
 * The longest text of an answer in memory, in bytes. With 255 (one frame) the code is smaller. With more, an answer of version 2 may fill
 * the memory.
 */
#ifndef JAVINO_TEXT_MAX
#if defined(__AVR__) || defined(JAVINO_VERSION_1_ONLY)
#define JAVINO_TEXT_MAX 255
#else
#define JAVINO_TEXT_MAX 65535
#endif
#endif

#if JAVINO_TEXT_MAX > 255
typedef uint16_t javino_room;
#else
typedef uint8_t javino_room;
#endif

/**
 * The number of shapes (texts of percepts without their digits) that a board distinguishes, at most 126. Each takes four bytes. Percepts
 * with other shapes are sent as text.
 */
#ifndef JAVINO_SHAPES
#ifdef __AVR__
#define JAVINO_SHAPES 16
#else
#define JAVINO_SHAPES 64
#endif
#endif

/** The CRC of a text without its digits, and the sum of the CRCs of all prefixes of that text. */
typedef struct {
    uint16_t crc;
    uint16_t sum;
} javino_shape;

struct javino_board;
struct javino_rules;

/** The points at which a board calls its rules, see javino_rules.h. */
enum {
    JAVINO_RULES_SET,     /**< The present command sets or removes rules. The call ends the command. */
    JAVINO_RULES_PERCEPT, /**< A percept has been written. */
    JAVINO_RULES_ANSWER,  /**< An answer is ready. The call returns true if the rules send the answer in place of the board. */
    JAVINO_RULES_GO_ON,   /**< The next part of an answer may go out. True: an answer is going out in parts. */
    JAVINO_RULES_END,     /**< A request is in hand, so the remaining parts of the answer before it go out. True: rules leave the new
                               answer less memory. */
    JAVINO_RULES_ALL      /**< Any time: the remaining parts of an answer go out. */
};

/** A board. Only link is public, for functions such as javino_link_receive. */
typedef struct javino_board {
    char *text;
    uint16_t memory; /* size in bytes */
    javino_room room;   /* longest text in bytes */
    javino_room length; /* length of text in bytes */
    javino_room whole;  /* length of the whole percepts in text */
    bool overlong;   /* whether the unfinished percept does not fit */
#ifndef JAVINO_VERSION_1_ONLY
    bool split;         /* whether a piece of the unfinished percept has gone out */
    javino_room coded;  /* length of the coded items */
    uint8_t part;       /* number of parts of the answer that have gone out */
    uint8_t answering;  /* number of the request that is answered in parts, or 0 */
    bool (*rule)(struct javino_board *board, uint8_t where); /* NULL if the board holds no rules */
    bool (*watches)(const struct javino_board *board, const char *functor, uint8_t length);
    struct javino_rules *rules;
#endif
    javino_link link;
#ifndef JAVINO_VERSION_1_ONLY
    javino_shape shapes[JAVINO_SHAPES]; /* the first link.shapes elements are in use */
#endif
} javino_board;

/**
 * Prepares a board.
 *
 * @param memory   belongs to the board from now on
 * @param size     size of the memory in bytes, JAVINO_MEMORY_MIN or more. With less than JAVINO_MEMORY the longest frames are lost. More
 *     memory helps with long answers, and with bytes that arrive during a long answer.
 * @param write    as for javino_link_init
 * @param context  passed to write
 * @return false if the size is less than JAVINO_MEMORY_MIN. Do not use the board then
 */
bool javino_board_init(javino_board *board, void *memory, uint16_t size, javino_write write, void *context);

/** Takes bytes from the end of the memory, for another use. @return NULL if too few would be left, or if percepts are being written */
void *javino_board_take(javino_board *board, uint16_t size);

/** Like javino_board_take, but from the beginning of the memory. @return NULL also if something has arrived */
void *javino_board_take_front(javino_board *board, uint16_t size);

/**
 * Like javino_link_poll. If a part of an answer has gone out, ends the answer. Forgets any other unsent answer. Unsent unasked percepts
 * join the next answer. Unsent unasked percepts that do not fit are forgotten.
 */
javino_event javino_board_poll(javino_board *board, uint16_t now_ms);

/** @return true if the present request asks for percepts with this functor, or if there is no request */
bool javino_board_wants(const javino_board *board, const char *functor, uint8_t length);

/**
 * Begins the description of a kind of percepts, for a computer that asks for kinds. Then write the kind's text, such as
 * `dist(front|left, cm 0..400)`, and call javino_percept_end.
 *
 * @return true if the present request asks for kinds; if false, write nothing and do not call javino_percept_end
 */
bool javino_kind_begin(javino_board *board);

/**
 * Begins a percept with its functor: an atom, perhaps after a ~. @return false if nobody wants the percept. After false, write nothing
 * more of the percept, and do not call javino_percept_end
 */
bool javino_percept_begin(javino_board *board, const char *functor);

/** Writes one character unchanged. */
void javino_percept_put(javino_board *board, char c);

/** Writes text unchanged. */
void javino_percept_text(javino_board *board, const char *text);

/** Writes a whole number. */
void javino_percept_number(javino_board *board, uint32_t magnitude, bool negative);

/** Writes text as an atom if possible (front), else as a string ("hi, you"). */
void javino_percept_term(javino_board *board, const char *text);

/** Writes any text as a string ("front"). */
void javino_percept_string(javino_board *board, const char *text);

/** Ends a percept. @return false if it is longer than 255 bytes in version 1, or if the memory is full and there is no request */
bool javino_percept_end(javino_board *board);

/** Sends the written percepts, even if there are none: as the answer, or unasked if there is no request. */
void javino_board_answer(javino_board *board);

/**
 * For javino_rules.c: sends the first n bytes of the text.
 * last: whether they are the end of the answer
 */
void javino_board_send_text(javino_board *board, bool last, javino_room n);

/** For javino_rules.c: moves the text to the end of the memory. At least `base` bytes before the text stay free for incoming frames. */
void javino_board_place(javino_board *board, uint16_t base);

/** Forgets the written percepts. */
void javino_board_clear(javino_board *board);

/**
 * Sends a message of any length. The message counts as the answer to the present request. In version 2 the message goes out in parts. In
 * version 1 a message that is longer than a frame goes out as several messages of whole percepts.
 *
 * @return false if a percept is longer than a frame of version 1
 */
bool javino_board_send(javino_board *board, const char *text, size_t length);

#ifdef __cplusplus
}
#endif

#endif
