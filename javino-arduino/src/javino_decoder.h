/** @file Finds the frames of the Javino protocol, versions 1 and 2, in the bytes that arrive. javino_frame.h has rules for all files. */
#ifndef JAVINO_DECODER_H
#define JAVINO_DECODER_H

#include "javino_frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The memory, in bytes, with which a decoder finds every possible frame: for the longest frame and the header of the next. */
#define JAVINO_WINDOW (JAVINO_OVERHEAD + JAVINO_MAX_PAYLOAD + 6)

/** The inter-byte timeout for a line of `baud` bits a second: 100 ms, or 20 byte times if that is longer. */
#define JAVINO_TIMEOUT_MS(baud) ((uint16_t)((baud) >= 2000 ? 100 : 200000UL / ((baud) < 50 ? 50 : (baud))))

/** Indexes into the bytes of a received frame of version 2, without escapes, and (the last) of version 1. */
enum { JAVINO_LENGTH_AT = 1, JAVINO_KIND_AT = 2, JAVINO_NUMBER_AT = 3, JAVINO_PAYLOAD_AT = 4, JAVINO_PAYLOAD_AT_1 = 6 };

/** What the bytes behind a frame of version 1 show. */
enum {
    JAVINO_FOLLOWS_UNKNOWN, /**< There are too few bytes to know. */
    JAVINO_FOLLOWS_HEADER,  /**< A header of another frame, or silence, follows: the frame was read correctly. */
    JAVINO_FOLLOWS_OTHER    /**< Anything else follows: the frame may have been misread. */
};
typedef uint8_t javino_follows;

/** Finds frames in a stream of bytes. The members are private. */
typedef struct {
    uint8_t *bytes;
    uint16_t size;
    uint16_t end;      /* number of bytes that have arrived */
    uint16_t gap;      /* number of bytes in front of a silence; 0: no silence */
    uint16_t taken;    /* bytes of the frame at the front; in version 2 those read so far, without escapes */
    uint16_t timeout_ms;
    uint16_t last_ms;
    uint16_t silence; /* ms of silence after the last byte, as far as is known */
    bool held; /* true: the frame at the front has been handed out */
    bool quiet;     /* true: a frame of version 1 may begin at the front */
    uint8_t session; /* nonce; 0: no session, so a frame of version 1 may begin anywhere */
    uint8_t damaged; /**< Number of damaged, dropped frames of version 2, modulo 256. May be read. */
} javino_decoder;

/**
 * Prepares a decoder.
 *
 * @param bytes       memory that belongs to the decoder from now on
 * @param size        number of those bytes: JAVINO_WINDOW, or fewer if long frames may be lost, but at least 12
 * @param timeout_ms  the silence between two bytes that ends an unfinished frame, at most 10,000. Call javino_decoder_next more often than
 *     every 20 s
 * @return false: the size is less than 12, so the decoder finds nothing
 */
bool javino_decoder_init(javino_decoder *decoder, uint8_t *bytes, uint16_t size, uint16_t timeout_ms);

/** @return true: javino_decoder_put has room; false: it has room after the next javino_decoder_next */
bool javino_decoder_ready(const javino_decoder *decoder);

/**
 * Takes one received byte. Call this only after javino_decoder_ready has returned true. now_ms is the time at which the byte is taken, so
 * that a byte that has waited in a receive buffer does not count as late.
 */
void javino_decoder_put(javino_decoder *decoder, uint8_t byte, uint16_t now_ms);

/**
 * Notices a silence, as javino_decoder_next also does. Call this during a long action, in which javino_decoder_next is not called:
 * otherwise silences go unnoticed. Call it when no byte is left in the receive buffer, or when javino_decoder_ready returns false.
 *
 * @param now_ms  the time of the last look into the receive buffer
 */
void javino_decoder_idle(javino_decoder *decoder, uint16_t now_ms);

/**
 * Begins a session of version 2; nonce 0 ends the session. During a session, a frame of version 1 is found only after a silence of a
 * quarter of the timeout, and its bytes are not read again.
 */
void javino_decoder_session(javino_decoder *decoder, uint8_t nonce);

/**
 * Looks for the next frame. The frame of the last call is no longer valid.
 *
 * A frame is found when its last byte has come. The bytes of a version 1 frame are kept until the next bytes are known. A header or silence
 * confirms the frame. Anything else means that the frame may have been misread, so its bytes are read again from the second on. They are
 * also read again if there is a silence within the frame.
 *
 * A frame of version 2 is dropped, and not read again, if it is damaged, too long for the memory, of another session, or not from a
 * computer. Without a session only the checksum of HELLO is checked. The checksum of other frames is unknown then; they only show that a
 * computer is there.
 *
 * @param now_ms  the time at which the receive buffer was last checked; it is empty unless javino_decoder_ready returns false
 * @return the frame: JAVINO_OVERHEAD bytes and its payload, in version 2 without escapes. After a frame, call this again before you hand in
 *     the next byte. NULL: no frame yet
 */
const uint8_t *javino_decoder_next(javino_decoder *decoder, uint16_t now_ms);

/**
 * Decides whether the version 1 frame in hand is whole, or is the beginning of a longer frame whose length was damaged. As there is no
 * checksum, the next bytes decide, or a silence of a sixteenth of the timeout.
 *
 * @param now_ms  as for javino_decoder_next
 * @return JAVINO_FOLLOWS_HEADER: the frame is whole; JAVINO_FOLLOWS_OTHER: it may not be whole; JAVINO_FOLLOWS_UNKNOWN: ask again later, or
 *     no frame is in hand
 */
javino_follows javino_decoder_follows(javino_decoder *decoder, uint16_t now_ms);

#ifdef __cplusplus
}
#endif

#endif
