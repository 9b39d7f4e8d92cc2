/**
 * @file The board's end of a line: sessions, requests, lost links, and commands. The link delivers each command once and in order.
 *     javino_frame.h has rules for all files.
 */
#ifndef JAVINO_LINK_H
#define JAVINO_LINK_H

#include "javino_decoder.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The number of version 2 bytes that the receive buffer holds while the program is busy, at most 255. */
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
    JAVINO_REQUEST, /**< A request for percepts. The text is empty, or lists functors: (dist,light). */
    JAVINO_WATCH,   /**< Only for javino_rules.h: percepts are being compared with rules. javino_link_poll never returns it. */
    JAVINO_ACTION,  /**< A command. The text is a literal. */
    JAVINO_RULE     /**< A command that sets or removes rules, see javino_rules.h. javino_board_poll handles this event. */
};
typedef uint8_t javino_event;

/** An action of a program. The computer may call an action by number. The program may store more data after each javino_action. */
typedef struct {
    const char *name;  /**< The action's functor, at most JAVINO_NAME_MAX bytes. The name must stay valid. */
    uint8_t arguments; /**< Number of arguments, or JAVINO_ANY. */
} javino_action;

/** The revision of version 2 in WELCOME. */
#define JAVINO_REVISION 1

/** The most actions of a board. Higher numbers on the line mean "no command" and rules. */
#define JAVINO_ACTIONS_MAX 126

/** The longest name of an action, in bytes, that fits into a page of the vocabulary. Computers never learn longer names. */
#define JAVINO_NAME_MAX (JAVINO_MAX_PAYLOAD - 5)

/** Any number of arguments. */
#define JAVINO_ANY 0xFF

/** A command with a later outcome. 0: there is none. */
typedef uint8_t javino_later;

/**
 * The board's end of a line. The caller may read event, text, length and session, and may set actions, action_size, action_count and
 * actions_lost. The other members are private.
 */
typedef struct {
    javino_event event; /**< The present message: JAVINO_REQUEST, JAVINO_ACTION or JAVINO_NOTHING. */
    uint8_t length;     /**< Length of the message's text in bytes. */
    const char *text;   /**< The message's text, not terminated. Valid until the message ends. */
    const void *actions;  /**< An array of javino_action. The last one has number 0. */
    uint8_t action_size;  /**< The distance between two actions in bytes. */
    uint8_t action_count; /**< At most JAVINO_ACTIONS_MAX. By default 0: the actions have no numbers. */
    bool answered;
    bool drained; /* whether the last poll has read all bytes */
    bool heard;   /* whether a valid frame has come since the last javino_link_lost */
    bool lost;
    uint8_t frames; /**< Number of intact frames, modulo 256. The caller may read this number. */
#ifndef JAVINO_VERSION_1_ONLY
    uint8_t session;    /**< The session's nonce; 0: no session, so version 1. The payload of WELCOME is this member and the next five. */
    uint8_t credit;
    uint8_t longest;    /* longest payload of a frame */
    uint8_t rules_max;  /* number of rules that the board can hold */
    uint8_t revision;
#endif
    uint8_t actions_lost; /**< Number of actions that were left out, at most 255. WELCOME reports this number. */
#ifndef JAVINO_VERSION_1_ONLY
    javino_later later; /* the newest action with a later outcome */
    uint8_t request;    /* number of the present request; 0: none, or answered */
    uint8_t due;        /* number of the next command. A session begins with 0 in this member and the next four. */
    uint8_t flags;      /* JAVINO_REFUSED, JAVINO_BUSY */
    uint8_t known;      /* number of shapes that the computer knows */
    uint8_t shapes;     /* number of shapes sent in this session */
    uint8_t rules;      /* number of rules that are set */
    bool row;           /* the present frame holds commands; length and number are those of the remaining commands */
#endif
    javino_encoder encoder;
    javino_decoder decoder;
    uint32_t since_ms;
    uint32_t drained_ms;
} javino_link;

/**
 * True if the present message is of version 2. Without a message: true if the next message goes out in version 2. A message of version 1
 * ends the session.
 */
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
 * @param size     size of this memory: JAVINO_WINDOW, or less if long frames may be lost
 * @param write    puts a byte on the line. `write` may call only one function of this link: javino_link_receive
 * @param context  passed to write
 */
void javino_link_init(javino_link *link, void *bytes, uint16_t size, javino_write write, void *context);

/** Sets the inter-byte timeout, see JAVINO_TIMEOUT_MS. By default 100 ms. */
void javino_link_timeout(javino_link *link, uint16_t timeout_ms);

/** @return true if javino_link_receive has room. If not, keep the byte and poll */
bool javino_link_ready(const javino_link *link);

/** Takes one received byte. Call this only after javino_link_ready has returned true. See javino_decoder_put. */
void javino_link_receive(javino_link *link, uint8_t byte, uint16_t now_ms);

/**
 * Ends the present message and looks for the next. A present command counts as carried out. Handles frames that do not concern the
 * program. Acknowledges a repeated command without returning it again. Call this at least every 20 s. javino_board_poll calls it for a
 * javino_board.
 *
 * Before each call pass in the waiting bytes, until there are none or javino_link_ready returns false.
 *
 * @param now_ms the time of the last check of the receive buffer. An earlier time does no harm. With a later time, bytes that came in
 *     between count as late. With any time, no command is carried out twice
 */
javino_event javino_link_poll(javino_link *link, uint16_t now_ms);

/** Ends the present message, if there is one. done: whether its command was carried out. In version 2 the computer learns `done`. */
void javino_link_finish(javino_link *link, bool done);

/**
 * Ends the present command without an outcome. javino_link_done must follow. Until then requests are answered, but no other command of
 * version 2 is carried out.
 *
 * @return the value for javino_link_done; 0 in version 1, or if there is no command
 */
javino_later javino_link_later(javino_link *link);

/**
 * Reports the outcome of a command that javino_link_later has ended. Do not call this while a frame is being written.
 * @return true if the outcome was reported; false if `later` is 0, or if a new session has begun
 */
bool javino_link_done(javino_link *link, javino_later later, bool done);

/** Starts to supervise the link. javino_link_lost measures silence from now on. */
void javino_link_supervise(javino_link *link, uint32_t now_ms);

/**
 * Returns true if the far end has fallen silent. The program should then stop motors. Call this after every javino_link_poll. Bytes that
 * arrived while the program was busy count as arrived at the beginning of that time.
 *
 * @param silence_ms the time without a valid frame after which the link is lost
 * @return true once, and again only after something has arrived
 */
bool javino_link_lost(javino_link *link, uint32_t silence_ms, uint32_t now_ms);

#ifndef JAVINO_VERSION_2_ONLY
/** Sends one frame of version 1. The frame counts as the answer to the present request. */
void javino_link_send(javino_link *link, const char *text, uint8_t length);
#endif

/**
 * Begins a frame of version 2, with the number of the next command. Then call javino_encoder_put exactly `length` times on link->encoder,
 * and javino_encoder_end once. `kind` must have no flags.
 */
void javino_link_begin(javino_link *link, uint8_t kind, uint8_t length);

#ifdef __cplusplus
}
#endif

#endif
