/**
 * @file
 * Finds the frames of the Javino protocol, versions 1 and 2, in the bytes that arrive. See javino_frame.h for the rules of all files.
 */
#ifndef JAVINO_DECODER_H
#define JAVINO_DECODER_H

#include "javino_frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Bytes that a decoder needs for every possible frame: the longest one and the next one's header. */
#define JAVINO_WINDOW (JAVINO_OVERHEAD + JAVINO_MAX_PAYLOAD + 6)

/** The inter-byte timeout for a line of baud bits a second: 100 ms or 20 byte times, whichever is longer. */
#define JAVINO_TIMEOUT_MS(baud) ((uint16_t)((baud) >= 2000 ? 100 : 200000UL / ((baud) < 50 ? 50 : (baud))))

/** The places of the parts of a received frame: those of version 2, without escapes, and the payload's in version 1. */
enum { JAVINO_LENGTH_AT = 1, JAVINO_KIND_AT = 2, JAVINO_NUMBER_AT = 3, JAVINO_PAYLOAD_AT = 4, JAVINO_PAYLOAD_AT_1 = 6 };

/** The bytes that follow a frame of version 1. */
enum {
    JAVINO_FOLLOWS_UNKNOWN, /**< Too few bytes yet to know. */
    JAVINO_FOLLOWS_HEADER,  /**< A preamble and two hex digits, or the start of a version 2 frame: the frame was read rightly. */
    JAVINO_FOLLOWS_OTHER    /**< Anything else: the frame may have been misread. */
};
typedef uint8_t javino_follows;

/** Finds frames in a stream of bytes. The members are private. */
typedef struct {
    uint8_t *bytes;
    uint16_t size;
    uint16_t end;      /* number of bytes there are */
    uint16_t gap;      /* place of a silence between the bytes; 0: there is none */
    uint16_t taken;    /* bytes of the frame at the front: all of them, or in version 2 those whose escapes are taken out */
    uint16_t timeout_ms;
    uint16_t last_ms;
    uint16_t silence; /* ms of silence at the end of the bytes, as far as is known */
    bool held; /* the frame at the front has been handed out */
    bool quiet;     /* a frame of version 1 may begin here */
    uint8_t session; /* nonce; 0: there is no session, and a frame of version 1 may begin anywhere */
    uint8_t damaged; /**< Frames of version 2 that have been dropped, modulo 256. May be read. */
} javino_decoder;

/**
 * Prepares a decoder.
 *
 * @param bytes       memory that belongs to the decoder from now on
 * @param size        number of those bytes: JAVINO_WINDOW, or fewer if longer frames may be lost, but at least 12
 * @param timeout_ms  silence between two bytes after which a frame that has begun is given up; at most
 *                    10,000. javino_decoder_next must be called more often than every 20 s.
 * @return false if the size is less than 12: such a decoder finds nothing
 */
bool javino_decoder_init(javino_decoder *decoder, uint8_t *bytes, uint16_t size, uint16_t timeout_ms);

/** @return true if javino_decoder_put has room. If not, it has room at the latest after the next javino_decoder_next. */
bool javino_decoder_ready(const javino_decoder *decoder);

/**
 * Takes one received byte. Only after javino_decoder_ready has returned true. The time at which the byte came does not matter: one that has
 * waited in a receive buffer is not late.
 *
 * @param now_ms  the time at which it was taken out of the receive buffer
 */
void javino_decoder_put(javino_decoder *decoder, uint8_t byte, uint16_t now_ms);

/**
 * Tells the decoder that the receive buffer is empty, unless javino_decoder_ready returns false. javino_decoder_next does so too; while
 * that is not called, as during a long action, only this tells silences.
 *
 * @param now_ms  the time of the last look into the receive buffer
 */
void javino_decoder_idle(javino_decoder *decoder, uint16_t now_ms);

/**
 * Begins a session of version 2: from now on a frame of version 1 counts only if it begins behind a silence of a quarter of
 * the timeout, and is not read twice.
 *
 * @param nonce the nonce of the session; 0 ends it
 */
void javino_decoder_session(javino_decoder *decoder, uint8_t nonce);

/**
 * Looks for the next frame. Ends the use of the frame before.
 *
 * A frame is found with its last byte. The bytes of one of version 1 are kept until it is known what follows them: a header or silence
 * confirms the frame; anything else means that it may have been misread, and the bytes after its first are read again. When silence falls
 * inside such a frame, its bytes after the first are read again too.
 *
 * A frame of version 2 that is damaged, too long for the memory, of another session or not from a computer is dropped and never read again.
 * Without a session only the checksum of HELLO is looked at: other frames cannot be checked, and only show that a computer is there.
 *
 * @param now_ms  the time of the last look into the receive buffer. Unless javino_decoder_ready returns false, nothing
 *                has come since the last byte handed in.
 * @return the frame, JAVINO_OVERHEAD bytes and its payload, of version 2 without escapes; if there is one, call this again before you hand
 *   in the next byte. NULL: there is none yet
 */
const uint8_t *javino_decoder_next(javino_decoder *decoder, uint16_t now_ms);

/**
 * Decides if the version 1 frame in hand is whole, or the beginning of a longer one whose size was damaged. There is no checksum; the next
 * bytes decide, or silence for a sixteenth of the timeout.
 *
 * @param now_ms  as for javino_decoder_next
 * @return JAVINO_FOLLOWS_HEADER: it is whole; JAVINO_FOLLOWS_OTHER: it is not, or may not be;
 *         JAVINO_FOLLOWS_UNKNOWN: ask again later; also if no frame is in hand
 */
javino_follows javino_decoder_follows(javino_decoder *decoder, uint16_t now_ms);

#ifdef __cplusplus
}
#endif

#endif
