/**
 * @file
 * The Javino wire protocol, versions 1 and 2, for the board's end of a serial line.
 *
 * Plain C99 without a heap, without floating point and without any board's header. All memory is the
 * caller's. Nothing waits: bytes are handed in one at a time, and the time, in milliseconds of a clock that
 * may wrap around, is handed in wherever it matters, often only its lower 16 bits. No function may be called from an interrupt; a receive
 * interrupt fills a buffer of its own, from which the program takes the bytes.
 *
 * Three layers, each usable without the next:
 *  - javino_decoder finds frames in the bytes that arrive;
 *  - javino_encoder writes a frame byte by byte;
 *  - javino_link holds the conversation: versions, sequence numbers, acknowledgements, a lost link.
 *
 * javino_board.h, on top of these, writes answers; javino_literal.h reads actions.
 */
#ifndef JAVINO_CORE_H
#define JAVINO_CORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__AVR__) && defined(__GNUC__)
/* Here a copy of a function that knows its arguments takes more flash than the calls it spares. */
#define JAVINO_OUTLINE __attribute__((noinline, noclone))
#else
#define JAVINO_OUTLINE
#endif

/** Payload bytes that a frame holds at most. */
#define JAVINO_MAX_PAYLOAD 255
/** Bytes of the longest frame, which is one of version 2. */
#define JAVINO_MAX_FRAME (12 + JAVINO_MAX_PAYLOAD)
/** Bytes that a decoder needs for every possible frame: the longest one and the next one's header. */
#define JAVINO_WINDOW (JAVINO_MAX_FRAME + 6)

/** Bytes of a request's text, getPercepts, before a list of functors in brackets. */
#define JAVINO_REQUEST_LENGTH 11

/** The inter-byte timeout for a rate of so many baud: 100 ms or 20 byte times, whichever is longer. */
#define JAVINO_TIMEOUT_MS(baud) ((uint16_t)((baud) >= 2000 ? 100 : 200000UL / ((baud) < 50 ? 50 : (baud))))

/** Flags of a version 2 frame, as they stand in its control byte beside a sequence number of 0-15. */
enum {
    JAVINO_MORE = 0x10,       /**< More fragments of the same message follow. */
    JAVINO_ACK_WANTED = 0x20, /**< The sender repeats the frame until it is acknowledged or refused. */
    JAVINO_ACK = 0x40,        /**< The action whose sequence number this frame echoes has been carried out. */
    JAVINO_REFUSAL = 0x80,    /**< The action whose sequence number this frame echoes is unknown or malformed. */
    JAVINO_SEQUENCE = 0x0F    /**< Mask of the sequence number. */
};

/* ---- CRC ---- */

/** The CRC before the first byte. */
#define JAVINO_CRC_START 0xFFFFu

/** @return CRC-16/CCITT-FALSE of the bytes so far (crc) and one more. */
uint16_t javino_crc16(uint16_t crc, uint8_t byte);

/* ---- Decoder ---- */

/** A frame that was received. */
typedef struct {
    const uint8_t *payload; /**< Not terminated. Stays in place until the next call of javino_decoder_next. */
    uint16_t crc;           /**< Version 2: the frame's checksum. */
    uint8_t length;         /**< Bytes of payload. */
    uint8_t version;        /**< 1 or 2. */
    uint8_t control;        /**< Version 2: the flags, JAVINO_MORE and so on, and the sequence number. */
    bool clean;             /**< Cannot be the inside of a damaged frame: see javino_decoder_next. */
} javino_frame;

/** What stands after a frame. */
enum {
    JAVINO_FOLLOWS_UNKNOWN, /**< Too few bytes yet to know. */
    JAVINO_FOLLOWS_HEADER,  /**< A preamble and two hex digits: the frame was read rightly. */
    JAVINO_FOLLOWS_OTHER    /**< Anything else: the frame may have been misread. */
};
typedef uint8_t javino_follows;

/** Finds frames in a stream of bytes. The members are private. */
typedef struct {
    uint8_t *bytes;
    uint16_t size;
    uint16_t end;      /* bytes there are */
    uint16_t gap;      /* where a silence lies between them; 0: nowhere */
    uint16_t held;     /* bytes of the frame at the front that has been handed out; 0: none has */
    uint16_t position; /* bytes read of the frame that begins behind that */
    uint16_t whole;    /* bytes that it will have */
    uint16_t work;     /* bytes that may still be read */
    uint8_t settled;   /* bytes of whole frames since the last byte of none; JAVINO_MAX_PAYLOAD: as many or more, or a pause */
    javino_frame read; /* what is known of it */
    uint16_t timeout_ms;
    uint16_t last_ms;
} javino_decoder;

/**
 * Prepares a decoder.
 *
 * @param bytes       memory that belongs to the decoder from now on
 * @param size        its bytes: JAVINO_WINDOW, or fewer where longer frames may be lost, but 12
 * @param timeout_ms  silence between two bytes after which a frame that has begun is given up; at most
 *                    10,000. javino_decoder_next must be called more often than every 20 s.
 * @return false if the size is less than 12: such a decoder finds nothing
 */
bool javino_decoder_init(javino_decoder *decoder, uint8_t *bytes, uint16_t size, uint16_t timeout_ms);

/** @return whether javino_decoder_put has room. If not, there is at the latest when javino_decoder_next is called again. */
bool javino_decoder_ready(const javino_decoder *decoder);

/**
 * Takes one received byte. Only after javino_decoder_ready has returned true. When the byte came does not matter: one
 * that has waited in a receive buffer is not late.
 *
 * @param now_ms  when it was taken out of the receive buffer
 */
void javino_decoder_put(javino_decoder *decoder, uint8_t byte, uint16_t now_ms);

/**
 * Tells the decoder that the receive buffer is empty, unless javino_decoder_ready returns false. javino_decoder_next does
 * so too; while that is not called, as during a long action, silences are known from this alone.
 *
 * @param now_ms  when the receive buffer was last looked into
 */
void javino_decoder_idle(javino_decoder *decoder, uint16_t now_ms);

/** Bytes that one call of javino_decoder_next or javino_link_poll reads at most, those that are read again included. */
#define JAVINO_WORK 1024

/**
 * Looks for the next frame. Ends the use of the frame before.
 *
 * A frame is found with its last byte. Its bytes are kept until what follows them is known: a header or
 * silence confirms the frame; anything else means that it may have been misread, and the bytes after its
 * first are read again. A version 2 frame with a wrong CRC is such a misreading and never handed out. When
 * silence falls inside a frame, its bytes after the first are read again and the rest is dropped.
 *
 * A frame is clean if it began after a pause of a quarter of the timeout, behind the frame before or behind nothing, or
 * if it began behind JAVINO_MAX_PAYLOAD bytes of whole frames. Any other may be the text of a damaged one.
 *
 * @param now_ms  when the receive buffer was last looked into. Unless javino_decoder_ready returns false, nothing
 *                has come since the last byte handed in.
 * @param frame   filled in when there is one
 * @return whether there is one; if so, ask again before the next byte. If not, there is none yet, or reading again
 *         has taken JAVINO_WORK bytes and goes on with the next call.
 */
bool javino_decoder_next(javino_decoder *decoder, uint16_t now_ms, javino_frame *frame);

/**
 * Whether the frame in hand can still turn out to be the beginning of a longer one whose size was damaged.
 * Version 1 has no checksum; what arrives next tells, or that nothing does for a sixteenth of the timeout.
 *
 * @param now_ms  as for javino_decoder_next
 * @return JAVINO_FOLLOWS_HEADER: it is whole; JAVINO_FOLLOWS_OTHER: it is not, or may not be;
 *         JAVINO_FOLLOWS_UNKNOWN: ask again later; also if no frame is in hand
 */
javino_follows javino_decoder_follows(javino_decoder *decoder, uint16_t now_ms);

/* ---- Encoder ---- */

/** Puts one byte on the line; may wait until there is room for it. */
typedef void (*javino_write)(void *context, uint8_t byte);

/** Writes one frame at a time. The members are private but for write and context, which the caller sets. */
typedef struct {
    javino_write write;
    void *context; /**< Handed to write. */
    uint16_t crc;
    uint8_t version;
} javino_encoder;

/**
 * Begins a frame. Exactly length calls of javino_encoder_put and one of javino_encoder_end must follow.
 *
 * @param version  1 or 2
 * @param control  flags and sequence number, which version 1 does not have
 */
void javino_encoder_begin(javino_encoder *encoder, uint8_t version, uint8_t control, uint8_t length);

/** Writes one byte of payload. */
void javino_encoder_put(javino_encoder *encoder, uint8_t byte);

/** Ends a frame. */
void javino_encoder_end(javino_encoder *encoder);

/* ---- Link ---- */

/** What javino_link_poll has found. */
enum {
    JAVINO_NOTHING, /**< No message. */
    JAVINO_REQUEST, /**< Percepts are asked for: getPercepts, perhaps with a list of functors. */
    JAVINO_ACTION   /**< Any other message: the text of a literal. */
};
typedef uint8_t javino_event;

/** The board's end of a line. The members are private but for event and frame, which may be read. */
typedef struct {
    javino_event event; /**< The message in hand: JAVINO_REQUEST, JAVINO_ACTION or JAVINO_NOTHING. */
    javino_frame frame; /**< Its frame. */
    javino_decoder decoder;
    javino_encoder encoder;
    uint16_t acted_ms;
    uint16_t acted_crc;
    uint8_t acted_control;
    uint8_t acted_outcome; /* 0: there is no action to remember */
    uint8_t sequence;
    bool answered;
    bool version2; /* the far end has spoken version 2 */
    bool untimed;  /* the action's outcome is newer than the last poll */
    bool drained;  /* the last poll has read all that there was */
    uint8_t part;  /* the control byte of the last clean frame */
    uint8_t later; /* the newest javino_later */
    bool heard;    /* something valid, since javino_link_lost was asked */
    bool lost;
    uint32_t since_ms;
    uint32_t drained_ms;
} javino_link;

/** An action whose outcome is reported later. 0: nobody waits for it. */
typedef uint8_t javino_later;

/**
 * Prepares a link. Its answers are of the version of the last frame heard, at first version 1.
 *
 * @param bytes    memory that belongs to the link from now on
 * @param size     its bytes: JAVINO_WINDOW, or fewer where longer frames may be lost
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

/** @return whether javino_link_receive has room. If not, leave the byte where it is and poll. */
bool javino_link_ready(const javino_link *link);

/** Takes one received byte. Only after javino_link_ready has returned true. As javino_decoder_put. */
void javino_link_receive(javino_link *link, uint8_t byte, uint16_t now_ms);

/**
 * Ends the message in hand, an action as carried out, and looks for the next. Whatever asks nothing of the
 * program is dealt with here; so are actions that are repeated because an acknowledgement was lost: they are
 * acknowledged again and not handed out. Call it more often than every 20 s, with a javino_board on top through
 * javino_board_poll.
 *
 * Before each call hand in all bytes that wait, until javino_link_ready returns false. An action is remembered for 3 s
 * from the call after its outcome, and until a call has found nothing more to read, so that a repetition that waited
 * while the program was busy is known.
 *
 * @param now_ms  when the receive buffer was last looked into; a time read before that does no harm, a later one
 *                takes what came in between for late
 */
javino_event javino_link_poll(javino_link *link, uint16_t now_ms);

/**
 * Ends the message in hand, if there is one. The far end is told if it wants to know.
 *
 * @param done  whether the action has been carried out; false if it is unknown or malformed
 */
void javino_link_finish(javino_link *link, bool done);

/**
 * Ends the action in hand without an outcome, which follows with javino_link_done. Until then a repetition of it is
 * neither carried out nor answered. ARGO waits for 2 to 5 s, longer for a board that has been slow before, and sends no
 * other command meanwhile.
 *
 * @return what to hand to javino_link_done; 0 in version 1 and if no action is in hand
 */
javino_later javino_link_later(javino_link *link);

/**
 * Reports the outcome of an action that javino_link_later has ended. Not while a frame is being written.
 *
 * @param done  whether it has been carried out; false if it could not be
 * @return whether it was reported; not if a newer action of version 2 has come since, or for 0
 */
bool javino_link_done(javino_link *link, javino_later later, bool done);

/** Begins to supervise the link: silence counts from now. */
void javino_link_supervise(javino_link *link, uint32_t now_ms);

/**
 * Whether the far end has fallen silent, so that motors had better stop. Ask after every javino_link_poll. What is
 * found after a while in which the program was busy counts as having come at its beginning.
 *
 * @param silence_ms  how long nothing valid has to have arrived
 * @return true once, and again only after something has arrived
 */
bool javino_link_lost(javino_link *link, uint32_t silence_ms, uint32_t now_ms);

/**
 * Sends one frame of a message. Counts as an answer to the request in hand.
 *
 * @param flags  JAVINO_MORE or 0; version 1 has no fragments
 */
void javino_link_send(javino_link *link, uint8_t flags, const char *text, uint8_t length);

#ifdef __cplusplus
}
#endif

#endif
