/**
 * @file The board's end of a line: sessions, requests, a lost link, and commands, each carried out once and in order. javino_frame.h has
 *     the rules of all files.
 */
#ifndef JAVINO_LINK_H
#define JAVINO_LINK_H

#include "javino_decoder.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The bytes of version 2 that the receive buffer holds while the program is busy; at most 255. */
#ifndef JAVINO_CREDIT
#if !defined(SERIAL_RX_BUFFER_SIZE) /* Arduino builds may set it for all files */
#define JAVINO_CREDIT 63
#elif SERIAL_RX_BUFFER_SIZE > 255
#define JAVINO_CREDIT 255
#else
#define JAVINO_CREDIT (SERIAL_RX_BUFFER_SIZE - 1)
#endif
#endif

/** The result of javino_link_poll. */
enum {
    JAVINO_NOTHING, /**< No message. */
    JAVINO_REQUEST, /**< A request for percepts. The text is empty, or names functors, as (dist,light). */
    JAVINO_WATCH,   /**< Never returned: percepts are being compared with rules, see javino_rules.h. */
    JAVINO_ACTION,  /**< A command. The text is a literal. */
    JAVINO_RULE     /**< Never returned for a javino_board, which handles it: rules are being set or removed, see javino_rules.h. */
};
typedef uint8_t javino_event;

/** An action of a program, which the computer may name by a number. Data of the program for the action may follow in memory. */
typedef struct {
    const char *name;  /**< The action's functor, which lasts; at most JAVINO_NAME_MAX bytes. */
    uint8_t arguments; /**< Number of its arguments, or JAVINO_ANY. */
} javino_action;

/** The revision of version 2 that this library speaks, for WELCOME. */
#define JAVINO_REVISION 1

/** The most actions of a board. On the line, higher numbers stand for "no command" and for rules. */
#define JAVINO_ACTIONS_MAX 126

/** The most bytes of an action's name that fit into a page of the vocabulary. Computers do not learn of an action with a longer name. */
#define JAVINO_NAME_MAX (JAVINO_MAX_PAYLOAD - 5)

/** Any number of arguments. */
#define JAVINO_ANY 0xFF

/** A command whose outcome is reported later. 0: nobody waits for the outcome. */
typedef uint8_t javino_later;

/**
 * The board's end of a line. The members are private, with two exceptions. The caller may read event, text, length and session, and may set
 * actions, action_size, action_count and actions_lost.
 */
typedef struct {
    javino_event event; /**< The message in hand: JAVINO_REQUEST, JAVINO_ACTION or JAVINO_NOTHING. */
    uint8_t length;     /**< Bytes of its text. */
    const char *text;   /**< Its text, not terminated. The event stays in place until the message is over. */
    const void *actions;  /**< A row of javino_action, numbered from the last. */
    uint8_t action_size;  /**< The distance between two actions in memory, in bytes. */
    uint8_t action_count; /**< At most JAVINO_ACTIONS_MAX. 0, the default: the actions have no numbers. */
    bool answered;
    bool drained; /* the last poll has read all bytes */
    bool heard;   /* something valid has come since the last javino_link_lost */
    bool lost;
    uint8_t frames; /**< Intact frames that have arrived, modulo 256. May be read. */
#ifndef JAVINO_VERSION_1_ONLY
    uint8_t session;    /**< Its nonce; 0: no session, and version 1. This member and the next five are the payload of WELCOME. */
    uint8_t credit;
    uint8_t longest;    /* most bytes of payload that a frame may have */
    uint8_t rules_max;  /* number of rules that the board can hold */
    uint8_t revision;
#endif
    uint8_t actions_lost; /**< Left-out actions of the program, at most 255, for the computer. */
#ifndef JAVINO_VERSION_1_ONLY
    javino_later later; /* the newest action whose outcome is reported later */
    uint8_t request;    /* number of the request in hand; 0: none, or answered */
    uint8_t due;        /* number of the next command. It and the next four begin as 0 in each session. */
    uint8_t flags;      /* JAVINO_REFUSED, JAVINO_BUSY */
    uint8_t known;      /* number of shapes whose text the computer knows */
    uint8_t shapes;     /* number of shapes that have been sent in this session */
    uint8_t rules;      /* number of rules that are set */
    bool row;           /* the frame in hand holds commands; its length and number now describe the commands that are left */
#endif
    javino_encoder encoder;
    javino_decoder decoder;
    uint32_t since_ms;
    uint32_t drained_ms;
} javino_link;

/** True if the message in hand, or else the next message sent, is of version 2. A message of version 1 ends the session. */
#if defined(JAVINO_VERSION_1_ONLY)
#define JAVINO_IS_2(link) false
#elif defined(JAVINO_VERSION_2_ONLY)
#define JAVINO_IS_2(link) true
#else
#define JAVINO_IS_2(link) ((link)->session != 0)
#endif

/**
 * Prepares a link. The link speaks version 1 until a computer begins a session of version 2.
 *
 * @param bytes    memory that belongs to the link from now on
 * @param size     number of those bytes: JAVINO_WINDOW, or fewer if longer frames may be lost
 * @param write    puts bytes on the line; may call only javino_link_receive of this link
 * @param context  handed to write
 */
void javino_link_init(javino_link *link, void *bytes, uint16_t size, javino_write write, void *context);

/** Sets the inter-byte timeout, see JAVINO_TIMEOUT_MS. It is 100 ms at first. */
void javino_link_timeout(javino_link *link, uint16_t timeout_ms);

/** @return true if javino_link_receive has room. If not, leave the byte where it is and poll. */
bool javino_link_ready(const javino_link *link);

/** Takes one received byte. Call this only after javino_link_ready has returned true. See javino_decoder_put. */
void javino_link_receive(javino_link *link, uint8_t byte, uint16_t now_ms);

/**
 * Ends the message in hand, whose command counts as carried out, and looks for the next. Handles frames that need no program. A command
 * that is repeated because an acknowledgement was lost is acknowledged again, but not handed out. Call it at least every 20 s; a
 * javino_board calls it in javino_board_poll.
 *
 * Before each call hand in all bytes that wait, until javino_link_ready returns false.
 *
 * @param now_ms the time of the last look into the receive buffer. An earlier time does no harm; with a later time, bytes that come in
 * between count as late. Whatever the time, no command is carried out twice
 */
javino_event javino_link_poll(javino_link *link, uint16_t now_ms);

/** Ends the message in hand, if any. Version 2 tells the computer whether its command was carried out (done). */
void javino_link_finish(javino_link *link, bool done);

/**
 * Ends the command in hand without an outcome; javino_link_done must follow. Until its outcome is reported, no other command of version 2
 * is carried out; requests are answered.
 *
 * @return the value for javino_link_done; 0: version 1, or no command is in hand
 */
javino_later javino_link_later(javino_link *link);

/**
 * Reports the outcome of a command that javino_link_later has ended: whether it was carried out. Not while a frame is being written.
 * @return true: the outcome was reported; false: a new session has begun since, or later is 0
 */
bool javino_link_done(javino_link *link, javino_later later, bool done);

/** Begins to supervise the link: silence counts from now. */
void javino_link_supervise(javino_link *link, uint32_t now_ms);

/**
 * Returns true if the far end has fallen silent, and motors should stop. Call it after every javino_link_poll. Bytes that arrived while the
 * program was busy count as arrived at the beginning of that time.
 *
 * @param silence_ms the time without a valid frame after which the link is lost
 * @return true once; and again only after something has arrived
 */
bool javino_link_lost(javino_link *link, uint32_t silence_ms, uint32_t now_ms);

#ifndef JAVINO_VERSION_2_ONLY
/** Sends one frame of version 1. Counts as an answer to the request in hand. */
void javino_link_send(javino_link *link, const char *text, uint8_t length);
#endif

/**
 * Begins a frame of version 2, with the number of the next command. On link->encoder, exactly length calls of javino_encoder_put and one of
 * javino_encoder_end must follow. The kind has no flags.
 */
void javino_link_begin(javino_link *link, uint8_t kind, uint8_t length);

#ifdef __cplusplus
}
#endif

#endif
