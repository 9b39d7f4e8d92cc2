/**
 * @file A board: a link, and the percepts with which it answers requests.
 *
 * An answer is text: percepts, each with a `;` behind it. The answer is built behind the received bytes, in the link's memory. The board
 * codes the answer in place when it is sent, or earlier if the memory is full. In version 2, a percept of which the computer knows
 * everything except the digits takes half a byte for each digit. If an answer still does not fit, its beginning goes out early: in version
 * 2 as a part of the answer, in version 1 as messages of whole percepts. Unasked percepts leave JAVINO_WINDOW bytes of memory free, so that
 * the longest frame can still arrive. In version 1 they are one message of at most 255 bytes.
 */
#ifndef JAVINO_BOARD_H
#define JAVINO_BOARD_H

#include "javino_link.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes of a board's memory that always remain for an answer. */
#define JAVINO_TEXT_MIN 64
/** The bytes of memory with which a board can receive every possible frame. */
#define JAVINO_MEMORY (JAVINO_WINDOW + JAVINO_TEXT_MIN)
/** The least memory, in bytes, that a board works with. */
#define JAVINO_MEMORY_MIN 160

/** The largest text of an answer, in bytes. A limit of 255 (one frame) takes less flash. In version 2 the text may fill the memory. */
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
 * How many shapes (texts of percepts without their digits) a board distinguishes, at most 126. Each takes four bytes. Percepts of further
 * shapes are sent as text.
 */
#ifndef JAVINO_SHAPES
#ifdef __AVR__
#define JAVINO_SHAPES 16
#else
#define JAVINO_SHAPES 64
#endif
#endif

/** The CRC of a text without its digits, and the sum of the CRCs of all beginnings of that text. */
typedef struct {
    uint16_t crc;
    uint16_t sum;
} javino_shape;

struct javino_board;
struct javino_rules;

/** The points at which a board calls its rules, see javino_rules.h. */
enum {
    JAVINO_RULES_SET,     /**< The command in hand sets or removes rules. The call ends the command. */
    JAVINO_RULES_PERCEPT, /**< A percept has been written. */
    JAVINO_RULES_ANSWER,  /**< An answer is ready. True: the rules send it, not the board. */
    JAVINO_RULES_GO_ON,   /**< The next part of an answer may go out. True: an answer is being sent in parts. */
    JAVINO_RULES_END,     /**< A request is in hand, so the remaining parts of the answer before it go out. True: rules leave the new
                               answer less memory. */
    JAVINO_RULES_ALL      /**< At any time: the remaining parts of an answer go out. */
};

/** A board. The members are private except link, which is for functions such as javino_link_receive. */
typedef struct javino_board {
    char *text;
    uint16_t memory; /* number of bytes */
    javino_room room;   /* most bytes that text may have */
    javino_room length; /* number of bytes of text */
    javino_room whole;  /* number of bytes of whole percepts in the text */
    bool overlong;   /* the unfinished percept does not fit */
#ifndef JAVINO_VERSION_1_ONLY
    bool split;         /* a piece of the unfinished percept has gone out */
    javino_room coded;  /* number of bytes of items in their final form */
    uint8_t part;       /* number of the answer's parts that have gone out; 0: none */
    uint8_t answering;  /* the request that is being answered in parts; 0: none */
    bool (*rule)(struct javino_board *board, uint8_t where); /* NULL: the board holds no rules */
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
 * @param size     number of the memory's bytes, JAVINO_MEMORY_MIN or more. With fewer than JAVINO_MEMORY the longest frames are lost. More
 *     memory helps with long answers, and with bytes that arrive during such an answer.
 * @param write    as for javino_link_init
 * @param context  handed to write
 * @return false: the size is less than JAVINO_MEMORY_MIN, so do not use the board
 */
bool javino_board_init(javino_board *board, void *memory, uint16_t size, javino_write write, void *context);

/** Takes bytes away from the end of the memory, for other use. @return NULL: too few would be left, or percepts are being written */
void *javino_board_take(javino_board *board, uint16_t size);

/** Like javino_board_take, from the beginning of the memory. @return NULL also if something has arrived */
void *javino_board_take_front(javino_board *board, uint16_t size);

/**
 * Like javino_link_poll. Ends an answer of which a part has gone out; forgets any other unsent answer. Unsent unasked percepts join the
 * next answer; if they do not fit there, they are forgotten.
 */
javino_event javino_board_poll(javino_board *board, uint16_t now_ms);

/** @return true: the request in hand asks for percepts of this functor, or no request is in hand */
bool javino_board_wants(const javino_board *board, const char *functor, uint8_t length);

/**
 * Begins the description of a kind of percepts, for a computer that asks for kinds. The kind's text must follow, such as
 * `dist(front|left, cm 0..400)`, and then javino_percept_end.
 *
 * @return true: the request in hand asks for kinds; false: write nothing, and do not end the description
 */
bool javino_kind_begin(javino_board *board);

/**
 * Begins a percept with its functor: an atom, perhaps behind a ~. @return false: nobody wants the percept, so write nothing more of it, and
 * do not end it
 */
bool javino_percept_begin(javino_board *board, const char *functor);

/** Writes one character unchanged. */
void javino_percept_put(javino_board *board, char c);

/** Writes text unchanged. */
void javino_percept_text(javino_board *board, const char *text);

/** Writes a whole number. */
void javino_percept_number(javino_board *board, uint32_t magnitude, bool negative);

/** Writes text as an atom if it is one (front), else as a string ("hi, you"). */
void javino_percept_term(javino_board *board, const char *text);

/** Writes any text as a string ("front"). */
void javino_percept_string(javino_board *board, const char *text);

/** Ends a percept. @return false: in version 1 it is longer than 255 bytes, or the memory is full and no request is in hand */
bool javino_percept_end(javino_board *board);

/** Sends the percepts written so far, even if there are none: as the answer or, without a request, unasked. */
void javino_board_answer(javino_board *board);

/** For javino_rules.c: sends the first n bytes of the text. last: they are the end of the answer. */
void javino_board_send_text(javino_board *board, bool last, javino_room n);

/** For javino_rules.c: moves the text to the end of the memory, behind at least `base` bytes for incoming frames. */
void javino_board_place(javino_board *board, uint16_t base);

/** Forgets the percepts written so far. */
void javino_board_clear(javino_board *board);

/**
 * Sends a message of any length. In version 2 it is divided into parts. In version 1, if it is longer than a frame, it is divided into
 * messages of whole percepts. It counts as the answer to the request in hand.
 *
 * @return true: everything has been sent; false: a percept is longer than a frame of version 1
 */
bool javino_board_send(javino_board *board, const char *text, size_t length);

#ifdef __cplusplus
}
#endif

#endif
