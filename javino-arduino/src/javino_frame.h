/**
 * @file Frames of the Javino protocol, versions 1 and 2: their kinds and bytes, their checksum, and the encoder that writes frames.
 *
 * Plain C99 without heap, floating point or a board's header. The caller owns all memory. No function waits. The caller passes in the
 * bytes one by one, and the time where it matters. Times are milliseconds of a clock that may wrap around, often only its lower 16 bits.
 * Do not call a function from an interrupt: a receive interrupt fills its own buffer, and the program takes the bytes from there.
 *
 * The layers, each usable without the later ones:
 *  - javino_frame.h: frames; javino_decoder.h: finds frames in received bytes;
 *  - javino_link.h: versions, sessions, commands and their outcomes, a lost link;
 *  - javino_board.h: answers made of percepts; javino_literal.h: the texts of actions.
 *
 * Switches leave parts out. Define them for all files:
 *  - JAVINO_VERSION_1_ONLY leaves out version 2;
 *  - JAVINO_VERSION_2_ONLY leaves out version 1 and javino_link_send(). Nothing is sent without a session;
 *  - JAVINO_NO_FUNCTOR_LISTS leaves out the functors in requests. The board then always answers with all percepts;
 *  - JAVINO_NO_DECIMALS leaves out numbers with decimals in the Arduino class.
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
/* On AVR, a copy of such a function for constant arguments costs more flash than it saves. */
#define JAVINO_OUTLINE __attribute__((noinline, noclone))
/* On AVR, a copy of such a function for constant arguments costs less flash than passing the arguments. */
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

/** The kinds of version 2 frames: values of the byte CC. */
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
    JAVINO_REFUSED = 0x40, /**< A flag in kinds from the board: the last command was refused. */
    JAVINO_BUSY = 0x20     /**< A flag in kinds from the board: an action is still being carried out. */
};

/** Begins a frame of version 2. A frame of version 1 begins with javino_preamble. */
#define JAVINO_START 0xA5
/** Precedes each escaped byte of a frame of version 2. */
#define JAVINO_ESCAPE 0xA4
/** An escaped byte is the original byte with these bits inverted. */
#define JAVINO_ESCAPED 0xA0

#ifndef JAVINO_VERSION_2_ONLY
/** The first bytes of a frame of version 1: fffe. */
extern const char javino_preamble[4];
#endif

/* ---- CRC ---- */

/** The CRC before the first byte of a frame in the session with this nonce. HELLO and WELCOME have nonce 0. */
#define JAVINO_CRC_START(nonce) ((uint16_t)((uint8_t)~(nonce) << 8 | 0xFF))

/** Adds a byte to a CRC-16/CCITT-FALSE. @param crc the CRC of the previous bytes @return the CRC with this byte */
uint16_t javino_crc16(uint16_t crc, uint8_t byte);

/* ---- Encoder ---- */

/** Puts one byte on the line. May wait for room. */
typedef void (*javino_write)(void *context, uint8_t byte);

/** Writes one frame at a time. The caller sets write and context. The other members are private. */
typedef struct {
    javino_write write;
    void *context; /**< Passed to write. */
    uint16_t crc;
    bool version2;
} javino_encoder;

#ifndef JAVINO_VERSION_2_ONLY
/** Begins a frame of version 1. Then call javino_encoder_put exactly `length` times, and javino_encoder_end once. */
void javino_encoder_begin(javino_encoder *encoder, uint8_t length);
#endif

/**
 * Begins a frame of version 2, with the bytes CC (kind) and SS (number). Then call javino_encoder_put and javino_encoder_end as in
 * version 1.
 */
void javino_encoder_begin2(javino_encoder *encoder, uint8_t nonce, uint8_t kind, uint8_t number, uint8_t length);

/** Writes one byte of payload. Escapes it in version 2 if necessary. */
void javino_encoder_put(javino_encoder *encoder, uint8_t byte);

/** Writes the last bytes of payload and ends the frame. */
void javino_encoder_finish(javino_encoder *encoder, const char *text, uint8_t length);

/** Ends a frame. */
void javino_encoder_end(javino_encoder *encoder);

#ifdef __cplusplus
}
#endif

#endif
