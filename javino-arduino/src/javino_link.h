/**
 * @file The board's end of a line: sessions, commands that are carried out once and in order, requests, a lost link. See javino_frame.h for
 * the rules of all files.
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
    JAVINO_REQUEST, /**< Percepts are asked for. The text is empty or the functors that are wanted, as in (dist,light). */
    JAVINO_WATCH,   /**< Never returned: the percepts that are written now are compared with rules, see javino_rules.h. */
    JAVINO_ACTION,  /**< A command. The text is a literal. */
    JAVINO_RULE     /**< Never returned for a javino_board, which handles it: rules are set or removed, see javino_rules.h. */
};
typedef uint8_t javino_event;

/**
 * An action of a program, which the computer may ask for and name by its number. A program's own data for the action may follow it in
 * memory.
 */
typedef struct {
    const char *name;  /**< Its functor, which lasts; at most JAVINO_NAME_MAX bytes. */
    uint8_t arguments; /**< How many it takes, or JAVINO_ANY. */
} javino_action;

/** The revision of version 2 that this library speaks, as WELCOME says. */
#define JAVINO_REVISION 1

/** The most actions of a board: on the line, the next numbers stand for no command and for rules. */
#define JAVINO_ACTIONS_MAX 126

/** The most bytes of an action's name, so that a page of the vocabulary holds it. With a longer name, computers know no action. */
#define JAVINO_NAME_MAX (JAVINO_MAX_PAYLOAD - 5)

/** Any number of arguments. */
#define JAVINO_ANY 0xFF

/** A command whose outcome is reported later. 0: nobody waits for it. */
typedef uint8_t javino_later;

/**
 * The board's end of a line. The members are private but for event, text, length and session, which may be read, and
 * actions, action_size, action_count and actions_lost, which may be set.
 */
typedef struct {
    javino_event event; /**< The message in hand: JAVINO_REQUEST, JAVINO_ACTION or JAVINO_NOTHING. */
    uint8_t length;     /**< Bytes of its text. */
    const char *text;   /**< Its text, not terminated. It stays in place until the message is over. */
    const void *actions;  /**< A row of javino_action, which are numbered from the last. */
    uint8_t action_size;  /**< The distance between two actions in memory, in bytes. */
    uint8_t action_count; /**< At most JAVINO_ACTIONS_MAX. 0, as at first: the actions have no numbers. */
    bool answered;
    bool drained; /* the last poll has read all that there was */
    bool heard;   /* something valid has come since javino_link_lost was asked */
    bool lost;
    uint8_t frames; /**< Intact ones that have arrived, modulo 256. May be read. */
#ifndef JAVINO_VERSION_1_ONLY
    uint8_t session;    /**< Its nonce; 0: there is none, and version 1 is spoken. This and the next five are the payload of WELCOME. */
    uint8_t credit;
    uint8_t longest;    /* most bytes of payload that a frame may have */
    uint8_t rules_max;  /* number of rules that the board can hold */
    uint8_t revision;
#endif
    uint8_t actions_lost; /**< Actions of the program that are left out, 255 at most: the computer is told. */
#ifndef JAVINO_VERSION_1_ONLY
    javino_later later; /* the newest action whose outcome is reported later */
    uint8_t request;    /* number of the request in hand; 0: there is none, or it is answered */
    uint8_t due;        /* number of the command that is carried out next. It and the next four begin as 0 in each session. */
    uint8_t flags;      /* JAVINO_REFUSED, JAVINO_BUSY */
    uint8_t known;      /* number of shapes whose text the computer knows */
    uint8_t shapes;     /* number of shapes that have been sent in this session */
    uint8_t rules;      /* number of rules that are set */
    bool row;           /* the frame in hand holds commands; its length and number are those of the commands that are left */
#endif
    javino_encoder encoder;
    javino_decoder decoder;
    uint32_t since_ms;
    uint32_t drained_ms;
} javino_link;

/** True if the message in hand is of version 2; without one, if the next sent message will be. A message of version 1 ends the session. */
#if defined(JAVINO_VERSION_1_ONLY)
#define JAVINO_IS_2(link) false
#elif defined(JAVINO_VERSION_2_ONLY)
#define JAVINO_IS_2(link) true
#else
#define JAVINO_IS_2(link) ((link)->session != 0)
#endif

/**
 * Prepares a link. It speaks version 1 until a computer begins a session of version 2.
 *
 * @param bytes    memory that belongs to the link from now on
 * @param size     number of those bytes: JAVINO_WINDOW, or fewer if longer frames may be lost
 * @param write    puts bytes on the line; may call javino_link_receive, but nothing else of this link
 * @param context  handed to write
 */
void javino_link_init(javino_link *link, void *bytes, uint16_t size, javino_write write, void *context);

/**
 * Sets the inter-byte timeout, which is 100 ms at first.
 *
 * @param timeout_ms  see JAVINO_TIMEOUT_MS
 */
void javino_link_timeout(javino_link *link, uint16_t timeout_ms);

/** @return true if javino_link_receive has room. If not, leave the byte where it is and poll. */
bool javino_link_ready(const javino_link *link);

/** Takes one received byte. Only after javino_link_ready has returned true. As javino_decoder_put. */
void javino_link_receive(javino_link *link, uint8_t byte, uint16_t now_ms);

/**
 * Ends the message in hand, where a command counts as carried out, and looks for the next. Frames that ask nothing of the program are
 * handled here; so are commands that are repeated because an acknowledgement was lost: they are acknowledged again and not handed out. Call
 * it more often than every 20 s, with a javino_board on top through javino_board_poll.
 *
 * Before each call hand in all bytes that wait, until javino_link_ready returns false.
 *
 * @param now_ms  the time of the last look into the receive buffer; an earlier time does no harm, with a later one bytes that came in
 * between count as late. No command is carried out twice whatever the time
 */
javino_event javino_link_poll(javino_link *link, uint16_t now_ms);

/**
 * Ends the message in hand, if there is one. Version 2 tells the computer.
 *
 * @param done  whether the command has been carried out; false if it is unknown or malformed
 */
void javino_link_finish(javino_link *link, bool done);

/**
 * Ends the command in hand without an outcome, which follows with javino_link_done. Until then no other command of
 * version 2 is carried out; requests are answered.
 *
 * @return the value for javino_link_done; 0 in version 1 and if no command is in hand
 */
javino_later javino_link_later(javino_link *link);

/**
 * Reports the outcome of a command that javino_link_later has ended. Not while a frame is being written.
 *
 * @param done  whether it has been carried out; false if it could not be
 * @return true if it was reported; not if a new session has begun since, or for 0
 */
bool javino_link_done(javino_link *link, javino_later later, bool done);

/** Begins to supervise the link: silence counts from now. */
void javino_link_supervise(javino_link *link, uint32_t now_ms);

/**
 * Returns true if the far end has fallen silent, so that motors should stop. Ask after every javino_link_poll. Bytes found after a time in
 * which the program was busy count as having come at the beginning of that time.
 *
 * @param silence_ms  the time without anything valid after which the link is lost
 * @return true once, and again only after something has arrived
 */
bool javino_link_lost(javino_link *link, uint32_t silence_ms, uint32_t now_ms);

#ifndef JAVINO_VERSION_2_ONLY
/** Sends one frame of version 1. Counts as an answer to the request in hand. */
void javino_link_send(javino_link *link, const char *text, uint8_t length);
#endif

/**
 * Begins a frame of version 2, with the number of the next command. Exactly length calls of javino_encoder_put and one of
 * javino_encoder_end must follow, on link->encoder.
 *
 * @param kind  JAVINO_ACK and so on, without flags
 */
void javino_link_begin(javino_link *link, uint8_t kind, uint8_t length);

#ifdef __cplusplus
}
#endif

#endif
