/**
 * @file The board's end of a line: sessions, requests, a lost link, and commands, each carried out once and in order. javino_frame.h has
 *     rules that hold for all files.
 */
#ifndef JAVINO_LINK_H
#define JAVINO_LINK_H

#include "javino_decoder.h"

#ifdef __cplusplus
extern "C" {
#endif

/** How many bytes of version 2 the receive buffer holds while the program is busy; at most 255. */
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
    JAVINO_WATCH,   /**< For javino_rules.h, never returned: percepts are being compared with rules. */
    JAVINO_ACTION,  /**< A command. The text is a literal. */
    JAVINO_RULE     /**< A command that sets or removes rules, see javino_rules.h. A javino_board handles it, and never returns it. */
};
typedef uint8_t javino_event;

/** An action of a program, which the computer may call by number. The program may store more data of the action behind it in memory. */
typedef struct {
    const char *name;  /**< The action's functor, at most JAVINO_NAME_MAX bytes. It must last. */
    uint8_t arguments; /**< Number of the action's arguments, or JAVINO_ANY. */
} javino_action;

/** The revision of version 2 that this library speaks, for WELCOME. */
#define JAVINO_REVISION 1

/** The most actions of a board. On the line, higher numbers mean "no command" and rules. */
#define JAVINO_ACTIONS_MAX 126

/** The most bytes of an action's name that fit into a page of the vocabulary. Computers do not learn of an action with a longer name. */
#define JAVINO_NAME_MAX (JAVINO_MAX_PAYLOAD - 5)

/** Any number of arguments. */
#define JAVINO_ANY 0xFF

/** A command whose outcome is reported later; 0: none, as nobody waits for the outcome. */
typedef uint8_t javino_later;

/**
 * The board's end of a line. The members are private, except that the caller may read event, text, length and session, and set actions,
 * action_size, action_count and actions_lost.
 */
typedef struct {
    javino_event event; /**< The message in hand: JAVINO_REQUEST, JAVINO_ACTION or JAVINO_NOTHING. */
    uint8_t length;     /**< Number of bytes of the message's text. */
    const char *text;   /**< The message's text, not terminated. It stays in place until the message is ended. */
    const void *actions;  /**< Several javino_action, one behind the other; the last has number 0. */
    uint8_t action_size;  /**< The distance between two actions in memory, in bytes. */
    uint8_t action_count; /**< At most JAVINO_ACTIONS_MAX. 0, the default: the actions have no numbers. */
    bool answered;
    bool drained; /* true: the last poll has read all bytes */
    bool heard;   /* true: something valid has come since the last javino_link_lost */
    bool lost;
    uint8_t frames; /**< Number of intact frames that have arrived, modulo 256. May be read. */
#ifndef JAVINO_VERSION_1_ONLY
    uint8_t session;    /**< The session's nonce; 0: no session, so version 1. This member and the next five are the payload of WELCOME. */
    uint8_t credit;
    uint8_t longest;    /* most bytes of payload that a frame may have */
    uint8_t rules_max;  /* number of rules that the board can hold */
    uint8_t revision;
#endif
    uint8_t actions_lost; /**< Number of the program's actions that were left out, at most 255; the computer is told. */
#ifndef JAVINO_VERSION_1_ONLY
    javino_later later; /* the newest action whose outcome is reported later */
    uint8_t request;    /* number of the request in hand; 0: none, or answered */
    uint8_t due;        /* number of the next command. This member and the next four are 0 when a session begins. */
    uint8_t flags;      /* JAVINO_REFUSED, JAVINO_BUSY */
    uint8_t known;      /* number of shapes whose text the computer knows */
    uint8_t shapes;     /* number of shapes that have been sent in this session */
    uint8_t rules;      /* number of rules that are set */
    bool row;           /* the frame in hand holds commands; its length and number describe those that are left */
#endif
    javino_encoder encoder;
    javino_decoder decoder;
    uint32_t since_ms;
    uint32_t drained_ms;
} javino_link;

/** True if the message in hand is of version 2 or, without one, if the next is sent so. A message of version 1 ends the session. */
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
 * @param size     number of those bytes: JAVINO_WINDOW, or fewer if long frames may be lost
 * @param write    puts a byte on the line; of this link's functions, it may call only javino_link_receive
 * @param context  handed to write
 */
void javino_link_init(javino_link *link, void *bytes, uint16_t size, javino_write write, void *context);

/** Sets the inter-byte timeout, see JAVINO_TIMEOUT_MS. It is 100 ms at first. */
void javino_link_timeout(javino_link *link, uint16_t timeout_ms);

/** @return true: javino_link_receive has room; false: leave the byte where it is, and poll */
bool javino_link_ready(const javino_link *link);

/** Takes one received byte. Call this only after javino_link_ready has returned true. See javino_decoder_put. */
void javino_link_receive(javino_link *link, uint8_t byte, uint16_t now_ms);

/**
 * Ends the message in hand, and looks for the next. A command in hand counts as carried out. Handles frames that do not concern the
 * program. A command that is repeated because an acknowledgement was lost is acknowledged again, but not handed out. Call this at least
 * every 20 s; javino_board_poll does so for a javino_board.
 *
 * Before each call hand in the waiting bytes, until none is left or javino_link_ready returns false.
 *
 * @param now_ms the time at which the receive buffer was last checked. An earlier time does no harm. With a later time, bytes that came in
 *     between count as late. With any time, no command is carried out twice
 */
javino_event javino_link_poll(javino_link *link, uint16_t now_ms);

/** Ends the message in hand, if any. done: whether its command was carried out, which the computer is told in version 2. */
void javino_link_finish(javino_link *link, bool done);

/**
 * Ends the command in hand without an outcome; javino_link_done must follow. Until the outcome is reported, requests are answered, but no
 * other command of version 2 is carried out.
 *
 * @return the value for javino_link_done; 0: version 1, or no command is in hand
 */
javino_later javino_link_later(javino_link *link);

/**
 * Reports whether a command that javino_link_later has ended was carried out. Do not call this while a frame is being written.
 * @return true: the outcome was reported; false: `later` is 0, or a new session has begun since
 */
bool javino_link_done(javino_link *link, javino_later later, bool done);

/** Begins to supervise the link: from now on, javino_link_lost measures silence. */
void javino_link_supervise(javino_link *link, uint32_t now_ms);

/**
 * Returns true if the far end has fallen silent, so that motors should stop. Call this after every javino_link_poll. Bytes that arrived
 * while the program was busy count as arrived at the beginning of that time.
 *
 * @param silence_ms the time without a valid frame after which the link is lost
 * @return true once; again only after something has arrived
 */
bool javino_link_lost(javino_link *link, uint32_t silence_ms, uint32_t now_ms);

#ifndef JAVINO_VERSION_2_ONLY
/** Sends one frame of version 1. It counts as the answer to the request in hand. */
void javino_link_send(javino_link *link, const char *text, uint8_t length);
#endif

/**
 * Begins a frame of version 2, with the number of the next command. On link->encoder, exactly `length` calls of javino_encoder_put and one
 * of javino_encoder_end must follow. `kind` must have no flags.
 */
void javino_link_begin(javino_link *link, uint8_t kind, uint8_t length);

#ifdef __cplusplus
}
#endif

#endif
