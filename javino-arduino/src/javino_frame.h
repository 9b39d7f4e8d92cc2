/**
 * @file Frames of the Javino protocol, versions 1 and 2: their kinds and bytes, their checksum, and the encoder that writes frames.
 *
 * Plain C99 without heap, floating point or a board's header. The caller owns all memory. No function waits: the caller hands in the bytes
 * one by one, and the time where it matters. Times are milliseconds of a clock that may wrap around, often only its lower 16 bits. Do not
 * call a function from an interrupt: a receive interrupt fills a buffer of its own, from which the program takes the bytes.
 *
 * The layers, each usable without the layers listed after it:
 *  - javino_frame.h: frames; javino_decoder.h: finds frames in received bytes;
 *  - javino_link.h: versions, sessions, commands and their outcomes, a lost link;
 *  - javino_board.h: answers made of percepts; javino_literal.h: the texts of actions.
 *
 * Switches leave parts out. Define them for all files:
 *  - JAVINO_VERSION_1_ONLY: version 2;
 *  - JAVINO_VERSION_2_ONLY: version 1. Then nothing is sent without a session, and there is no javino_link_send();
 *  - JAVINO_NO_FUNCTOR_LISTS: the functors in requests. The board then always answers with all percepts;
 *  - JAVINO_NO_DECIMALS: numbers with decimals, in the Arduino class.
 */
#ifndef JAVINO_FRAME_H
#define JAVINO_FRAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__AVR__) && defined(__GNUC__)
/* On AVR, a copy of such a function for known arguments takes more flash than it saves in calls. */
#define JAVINO_OUTLINE __attribute__((noinline, noclone))
/* On AVR, a copy of such a function for known arguments takes less flash than the arguments in each call. */
#define JAVINO_NOINLINE __attribute__((noinline))
#else
#define JAVINO_OUTLINE
#define JAVINO_NOINLINE
#endif

#if defined(JAVINO_VERSION_1_ONLY) && defined(JAVINO_VERSION_2_ONLY)
#error "JAVINO_VERSION_1_ONLY and JAVINO_VERSION_2_ONLY leave nothing"
#endif

/** The largest payload of a frame, in bytes. */
#define JAVINO_MAX_PAYLOAD 255
/** Bytes around a payload, in either version, before escaping. */
#define JAVINO_OVERHEAD 6

/** The kinds of version 2 frames, as their byte CC has them. */
enum {
    JAVINO_HELLO = 0x10,
    JAVINO_ASK = 0x20,
    JAVINO_DESCRIBE = 0x28,
    JAVINO_COMMANDS = 0x30,
    JAVINO_RESUME = 0x31, /**< Commands, after the computer has seen a refusal. */
    JAVINO_WELCOME = 0x80,
    JAVINO_ACK = 0x81,
    JAVINO_PERCEPTS = 0x82,
    JAVINO_PERCEPTS_PART = 0x83,
    JAVINO_PERCEPTS_LAST = 0x84,
    JAVINO_CRITICAL = 0x85,
    JAVINO_VOCABULARY = 0x86,
    JAVINO_REFUSED = 0x40, /**< A flag in kinds from the board. */
    JAVINO_BUSY = 0x20     /**< A flag in kinds from the board. */
};

/** Begins a frame of version 2. A frame of version 1 begins with javino_preamble. */
#define JAVINO_START 0xA5
/** Stands in front of each escaped byte of a frame of version 2. */
#define JAVINO_ESCAPE 0xA4
/** The bits in which an escaped byte differs from the byte that it stands for. */
#define JAVINO_ESCAPED 0xA0

#ifndef JAVINO_VERSION_2_ONLY
/** The first bytes of a frame of version 1: fffe. */
extern const char javino_preamble[4];
#endif

/* ---- CRC ---- */

/** The CRC before the first byte of a frame of the session with this nonce; the nonce is 0 for HELLO and WELCOME. */
#define JAVINO_CRC_START(nonce) ((uint16_t)((uint8_t)~(nonce) << 8 | 0xFF))

/** Adds a byte to a CRC-16/CCITT-FALSE. @param crc that of the bytes so far @return that of these bytes and byte */
uint16_t javino_crc16(uint16_t crc, uint8_t byte);

/* ---- Encoder ---- */

/** Puts one byte on the line; may wait for room. */
typedef void (*javino_write)(void *context, uint8_t byte);

/** Writes one frame at a time. The members are private; the caller sets write and context. */
typedef struct {
    javino_write write;
    void *context; /**< Handed to write. */
    uint16_t crc;
    bool version2;
} javino_encoder;

#ifndef JAVINO_VERSION_2_ONLY
/** Begins a frame of version 1. Exactly `length` calls of javino_encoder_put and one of javino_encoder_end must follow. */
void javino_encoder_begin(javino_encoder *encoder, uint8_t length);
#endif

/** Begins a frame of version 2, with the bytes CC (kind) and SS (number). The same calls must follow as after javino_encoder_begin. */
void javino_encoder_begin2(javino_encoder *encoder, uint8_t nonce, uint8_t kind, uint8_t number, uint8_t length);

/** Writes one byte of payload; in version 2 it is escaped if necessary. */
void javino_encoder_put(javino_encoder *encoder, uint8_t byte);

/** Writes the last bytes of payload and ends the frame. */
void javino_encoder_finish(javino_encoder *encoder, const char *text, uint8_t length);

/** Ends a frame. */
void javino_encoder_end(javino_encoder *encoder);

#ifdef __cplusplus
}
#endif

#endif
