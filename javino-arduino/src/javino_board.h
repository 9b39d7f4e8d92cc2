/**
 * @file A board: a link, and the percepts with which it answers requests.
 *
 * An answer is text: percepts, each with a `;` behind it. The answer is built behind the received bytes, in the link's memory. The board
 * codes it in place when it is sent, or earlier if the memory is full. In version 2, if the computer knows all of a percept except its
 * digits, the percept takes half a byte for each digit. If an answer still does not fit, its beginning goes out early: in version 2 as a
 * part of the answer, in version 1 as messages of whole percepts. Unasked percepts leave JAVINO_WINDOW bytes of memory free, so the longest
 * frame still arrives. In version 1 they are one message of at most 255 bytes.
 */
#ifndef JAVINO_BOARD_H
#define JAVINO_BOARD_H

#include "javino_link.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes of a board's memory that always remain for an answer. */
#define JAVINO_TEXT_MIN 64
/** Bytes of memory with which a board receives every possible frame. */
#define JAVINO_MEMORY (JAVINO_WINDOW + JAVINO_TEXT_MIN)
/** The least memory, in bytes, that a board works with. */
#define JAVINO_MEMORY_MIN 160

/** The largest text in bytes. 255, the text of one frame, takes less flash. In version 2 the text may fill the memory. */
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
 * shapes go as text.
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
    JAVINO_RULES_SET,     /**< A command in hand sets or removes rules. The call ends it. */
    JAVINO_RULES_PERCEPT, /**< A percept is whole. */
    JAVINO_RULES_ANSWER,  /**< An answer is ready. True: the board does not send it. */
    JAVINO_RULES_GO_ON,   /**< The next part of an answer may go out. True: an answer is going out in parts. */
    JAVINO_RULES_END,     /**< A request is in hand, so the rest of an answer in parts goes out. True: rules leave the new answer less
                               memory. */
    JAVINO_RULES_ALL      /**< The rest of an answer in parts goes out, at any time. */
};

/** A board. The members are private except link, which is for functions such as javino_link_receive. */
typedef struct javino_board {
    char *text;
    uint16_t memory; /* number of bytes */
    javino_room room;   /* number of bytes that text may have */
    javino_room length; /* number of bytes of text */
    javino_room whole;  /* number of bytes of whole percepts in the text */
    bool overlong;   /* the unfinished percept does not fit */
#ifndef JAVINO_VERSION_1_ONLY
    bool split;         /* a piece of the unfinished percept has gone out */
    javino_room coded;  /* number of bytes of items in their final form */
    uint8_t part;       /* number of parts that have gone out; 0: no answer has been begun */
    uint8_t answering;  /* the request that is being answered in parts; 0: none */
    bool (*rule)(struct javino_board *board, uint8_t where); /* NULL: the board holds no rules */
    bool (*watches)(const struct javino_board *board, const char *functor, uint8_t length);
    struct javino_rules *rules;
#endif
    javino_link link;
#ifndef JAVINO_VERSION_1_ONLY
    javino_shape shapes[JAVINO_SHAPES]; /* the first link.shapes of them are in use */
#endif
} javino_board;

/**
 * Prepares a board.
 *
 * @param memory   belongs to the board from now on
 * @param size     its bytes, JAVINO_MEMORY_MIN or more. With less than JAVINO_MEMORY the longest frames are not received. More memory
 * helps with long answers, and with bytes that arrive during such an answer.
 * @param write    as for javino_link_init
 * @param context  handed to write
 * @return false if the size is less than JAVINO_MEMORY_MIN; then do not use the board
 */
bool javino_board_init(javino_board *board, void *memory, uint16_t size, javino_write write, void *context);

/** Takes bytes away from the end of the memory. @return NULL: too few bytes would be left, or percepts are being written */
void *javino_board_take(javino_board *board, uint16_t size);

/** Like javino_board_take, from the beginning of the memory. @return NULL also if something has arrived */
void *javino_board_take_front(javino_board *board, uint16_t size);

/**
 * Like javino_link_poll. An unsent answer is ended if a part of it has gone out, else forgotten. Unasked percepts wait for the next answer;
 * if they do not fit there, they are forgotten.
 */
javino_event javino_board_poll(javino_board *board, uint16_t now_ms);

/** @return true if the request in hand asks for percepts of this functor, or if no request is in hand */
bool javino_board_wants(const javino_board *board, const char *functor, uint8_t length);

/**
 * Begins the description of a kind of percepts, for a computer that asks for kinds. The kind's text must follow, such as
 * `dist(front|left, cm 0..400)`, and then javino_percept_end.
 *
 * @return true: the request in hand asks for kinds; false: write nothing, and do not end the description
 */
bool javino_kind_begin(javino_board *board);

/**
 * Begins a percept with its functor: an atom, perhaps behind a ~. @return false: nobody wants the percept, so write nothing, and do not end
 * it
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

/** Sends the percepts written so far, even none: as the answer or, without a request, unasked. */
void javino_board_answer(javino_board *board);

/** For javino_rules.c: sends n bytes of the text, as the end of an answer or before the rest of the answer. */
void javino_board_send_text(javino_board *board, bool last, javino_room n);

/** For javino_rules.c: moves the text to the end of the memory, behind at least `base` bytes for incoming frames. */
void javino_board_place(javino_board *board, uint16_t base);

/** Forgets the percepts written so far. */
void javino_board_clear(javino_board *board);

/**
 * Sends a message of any length. Version 2 divides it into parts; version 1 divides a message that is longer than a frame into messages of
 * whole percepts. The message counts as an answer to the request in hand.
 *
 * @return true: all of it has been sent; false: a percept is longer than a frame of version 1
 */
bool javino_board_send(javino_board *board, const char *text, size_t length);

#ifdef __cplusplus
}
#endif

#endif
