/** @file Finds the frames of the Javino protocol, versions 1 and 2, in arriving bytes. javino_frame.h has rules for all files. */
#ifndef JAVINO_DECODER_H
#define JAVINO_DECODER_H

#include "javino_frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/** The memory, in bytes, with which a decoder finds every frame: the longest frame and the header of the next. */
#define JAVINO_WINDOW (JAVINO_OVERHEAD + JAVINO_MAX_PAYLOAD + 6)

/** The inter-byte timeout for a line of `baud` bits a second: 100 ms, or 20 byte times if they take longer. */
#define JAVINO_TIMEOUT_MS(baud) ((uint16_t)((baud) >= 2000 ? 100 : 200000UL / ((baud) < 50 ? 50 : (baud))))

/** Indexes into the bytes of a received frame. The last one is for version 1, the others are for version 2 without escapes. */
enum { JAVINO_LENGTH_AT = 1, JAVINO_KIND_AT = 2, JAVINO_NUMBER_AT = 3, JAVINO_PAYLOAD_AT = 4, JAVINO_PAYLOAD_AT_1 = 6 };

/** What follows a frame of version 1. */
enum {
    JAVINO_FOLLOWS_UNKNOWN, /**< There are too few bytes to know. */
    JAVINO_FOLLOWS_HEADER,  /**< The header of another frame, or silence, follows. The frame was read correctly. */
    JAVINO_FOLLOWS_OTHER    /**< Other bytes follow. The frame may have been misread. */
};
typedef uint8_t javino_follows;

/** Finds frames in a stream of bytes. The members are private. */
typedef struct {
    uint8_t *bytes;
    uint16_t size;
    uint16_t end;      /* number of bytes held */
    uint16_t gap;      /* number of bytes before a silence, or 0 */
    uint16_t taken;    /* length of the first frame; in version 2 the part read so far, without escapes */
    uint16_t timeout_ms;
    uint16_t last_ms;
    uint16_t silence; /* ms of known silence after the last byte */
    bool held; /* whether the first frame has been delivered */
    bool quiet;     /* whether a frame of version 1 may begin at the first byte */
    uint8_t session; /* nonce, or 0 without a session: a frame of version 1 may then begin anywhere */
    uint8_t damaged; /**< Number of dropped damaged frames of version 2, modulo 256. Public. */
} javino_decoder;

/**
 * Prepares a decoder.
 *
 * @param bytes       memory that belongs to the decoder from now on
 * @param size        size of this memory: JAVINO_WINDOW, or less if long frames may be lost, but at least 12
 * @param timeout_ms  the silence between two bytes that ends an unfinished frame, at most 10,000. Call javino_decoder_next more often
 *     than every 20 s
 * @return false if the size is less than 12. The decoder then finds nothing
 */
bool javino_decoder_init(javino_decoder *decoder, uint8_t *bytes, uint16_t size, uint16_t timeout_ms);

/** @return true if javino_decoder_put has room. If not, javino_decoder_next makes room */
bool javino_decoder_ready(const javino_decoder *decoder);

/**
 * Takes one received byte. Call this only after javino_decoder_ready has returned true. now_ms is the time of the call. A byte that has
 * waited in a receive buffer therefore does not count as late.
 */
void javino_decoder_put(javino_decoder *decoder, uint8_t byte, uint16_t now_ms);

/**
 * Notices a silence. javino_decoder_next also does this. Call this function regularly during a long action, because javino_decoder_next
 * is not called then. Call it when the receive buffer is empty, or when javino_decoder_ready returns false.
 *
 * @param now_ms  the time of the last check of the receive buffer
 */
void javino_decoder_idle(javino_decoder *decoder, uint16_t now_ms);

/**
 * Begins a session of version 2. Nonce 0 ends the session. During a session, a frame of version 1 is found only after a silence of a
 * quarter of the timeout. The decoder does not read the bytes of this frame again.
 */
void javino_decoder_session(javino_decoder *decoder, uint8_t nonce);

/**
 * Looks for the next frame. The frame of the last call becomes invalid.
 *
 * A frame is found when its last byte has come. The decoder keeps the bytes of a version 1 frame until it knows the next bytes. A header
 * or silence confirms the frame. Other bytes mean that the frame may have been misread. The decoder then reads its bytes again, from the
 * second on. The decoder also reads a frame's bytes again after a silence within the frame.
 *
 * The decoder drops some frames of version 2 without reading them again: damaged frames, frames too long for the memory, frames of
 * another session, and frames not from a computer. Without a session only the checksum of HELLO is checked. The checksum of other frames
 * is unknown then. The other frames only show that a computer is present.
 *
 * @param now_ms  the time of the last check of the receive buffer. The buffer must be empty, or javino_decoder_ready must return false
 * @return the frame: JAVINO_OVERHEAD bytes and its payload, in version 2 without escapes. After a frame, call this again before the next
 *     byte. NULL: no frame yet
 */
const uint8_t *javino_decoder_next(javino_decoder *decoder, uint16_t now_ms);

/**
 * Decides whether the present version 1 frame is complete, or the beginning of a longer frame with a damaged length. There is no
 * checksum, so the next bytes decide, or a silence of a sixteenth of the timeout.
 *
 * @param now_ms  as for javino_decoder_next
 * @return JAVINO_FOLLOWS_HEADER: the frame is complete; JAVINO_FOLLOWS_OTHER: it may be incomplete; JAVINO_FOLLOWS_UNKNOWN: call again
 *     later, or there is no frame
 */
javino_follows javino_decoder_follows(javino_decoder *decoder, uint16_t now_ms);

#ifdef __cplusplus
}
#endif

#endif
