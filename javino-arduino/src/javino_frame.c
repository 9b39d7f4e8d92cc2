#include "javino_frame.h"

#include <string.h>

#define HEADER 6 /* bytes of preamble and size in version 1 */
#define NO_DIGIT 16

#define START 0xA5
#define ESCAPE 0xA4
#define ESCAPED 0xA0 /* what differs between a byte and the one behind an escape that stands for it */
/* Where they stand in a frame of version 2 without escapes. */
#define LENGTH_AT 1
#define KIND_AT 2
#define NUMBER_AT 3
#define PAYLOAD_AT 4

#ifdef JAVINO_VERSION_1_ONLY
#define IS_FRAME_2(bytes) false
#else
#define IS_FRAME_2(bytes) (*(bytes) == START)
#endif

/* ---- Hex and CRC ---- */

static uint8_t digit_value(uint8_t c)
{
    if (c >= '0' && c <= '9')
        return (uint8_t)(c - '0');
    c |= 0x20;
    return c >= 'a' && c <= 'f' ? (uint8_t)(c - ('a' - 10)) : NO_DIGIT;
}

JAVINO_OUTLINE uint16_t javino_crc16(uint16_t crc, uint8_t byte)
{
    /* The polynomial division of a whole byte, done at once. */
    uint8_t high = (uint8_t)(crc >> 8) ^ byte;
    high ^= high >> 4;
    return (uint16_t)(((uint8_t)crc ^ (uint8_t)(high << 4) ^ high >> 3) << 8) | (uint8_t)(high ^ (uint8_t)(high << 5));
}

/* ---- Decoder ---- */

/* The milliseconds that have passed; none if was is in the future: a byte may have come while the caller's now was growing
 * old. */
static uint16_t elapsed(uint16_t now, uint16_t was)
{
    now -= was;
    return now < 0x8000u ? now : 0;
}

JAVINO_OUTLINE bool javino_decoder_init(javino_decoder *decoder, uint8_t *bytes, uint16_t size, uint16_t timeout_ms)
{
    memset(decoder, 0, sizeof *decoder);
    decoder->bytes = bytes;
    decoder->size = size;
    decoder->timeout_ms = timeout_ms;
    decoder->quiet = true;
    return size >= 2 * HEADER;
}

/* Without room there may be bytes that have not been handed in, and when they came is not known. While a frame is in
 * hand there can be a second silence; then the first counts, since what lies before it has been waiting longer. */
JAVINO_OUTLINE void javino_decoder_idle(javino_decoder *decoder, uint16_t now_ms)
{
    javino_decoder *d = decoder;
    uint16_t silence;
    if (d->end >= d->size)
        d->last_ms = now_ms;
    silence = elapsed(now_ms, d->last_ms);
    if (d->end == d->held && silence > d->timeout_ms / 4)
        d->quiet = true;
    if (!d->gap && silence > d->timeout_ms)
        d->gap = d->end;
}

JAVINO_OUTLINE bool javino_decoder_ready(const javino_decoder *decoder)
{
    return decoder->end < decoder->size;
}

JAVINO_OUTLINE void javino_decoder_put(javino_decoder *decoder, uint8_t byte, uint16_t now_ms)
{
    decoder->bytes[decoder->end++] = byte;
    decoder->last_ms = now_ms;
}

void javino_decoder_session(javino_decoder *decoder)
{
    decoder->session = true;
    decoder->quiet = false;
}

#ifndef JAVINO_VERSION_1_ONLY

/* Of a computer's frame. */
static bool is_kind(uint8_t kind)
{
    return kind == JAVINO_HELLO || kind == JAVINO_ASK || kind == JAVINO_DESCRIBE || (kind & 0xFE) == JAVINO_COMMANDS;
}

static bool is_intact(const uint8_t *frame, uint16_t length)
{
    uint16_t crc = JAVINO_CRC_START;
    while (--length)
        crc = javino_crc16(crc, *++frame);
    return crc == 0; /* Over a checksum, too, it is none. */
}

/**
 * Reads on in the frame of version 2 at the front, as far as the bytes go, and takes the escapes out of them.
 *
 * FOLLOWS_HEADER: it is whole; FOLLOWS_OTHER: it is damaged, and ends with or in front of the byte that shows it. In either
 * case position is the bytes that it takes.
 */
static javino_follows read_frame2(javino_decoder *d, uint8_t *p, uint16_t stop)
{
    const uint8_t *end = p + stop;
    const uint8_t *in = p + d->position;
    uint8_t *out = p + d->position;
    bool intact = false;
    while (in < end) {
        uint8_t c = *in;
        uint16_t place = (uint16_t)(out - p);
        if (c == START && place)
            goto ended;
        if (c == ESCAPE) {
            if (in + 1 == end)
                break;
            if (*++in == START)
                goto ended;
            c = *in ^ ESCAPED;
            in++;
            if (c != START && c != ESCAPE)
                goto ended;
        } else {
            in++;
        }
        *out++ = c;
        if (place == LENGTH_AT) {
            if (c >= d->size - JAVINO_OVERHEAD)
                goto ended;
            d->length = c;
        } else if (place == KIND_AT) {
            if (!is_kind(c))
                goto ended;
        } else if (place == (uint16_t)(d->length + JAVINO_OVERHEAD - 1) && place > KIND_AT) {
            intact = is_intact(p, place + 1);
            goto ended;
        }
    }
    if (!d->gap) {
        memmove(out, in, (size_t)(p + d->end - in));
        d->end -= (uint16_t)(in - out);
        d->position = (uint16_t)(out - p);
        return JAVINO_FOLLOWS_UNKNOWN;
    }
    in = end;
ended:
    d->position = (uint16_t)(in - p);
    return intact ? JAVINO_FOLLOWS_HEADER : JAVINO_FOLLOWS_OTHER;
}
#endif

/* Reads the next byte of a frame of version 1; false if it cannot stand there. */
static bool read_byte(javino_decoder *d, uint8_t c)
{
    uint16_t position = d->position;
    uint8_t wanted = position < 3 ? 'f' : 'e';
    uint8_t value;
    if (position >= HEADER)
        return true;
    if (position < 4)
        return c == wanted;
    value = digit_value(c);
    d->length = (uint8_t)(d->length << 4) | value;
    return value != NO_DIGIT;
}

/* Reads on as far as the bytes go. FOLLOWS_HEADER: a whole frame or, behind a frame that is held, a header or
 * silence; FOLLOWS_OTHER: the bytes make no frame; FOLLOWS_UNKNOWN: there are no more yet. */
static JAVINO_OUTLINE javino_follows read_on(javino_decoder *d, uint8_t *p)
{
    uint16_t stop = d->gap ? d->gap : d->end;
    uint16_t held = d->held;
#ifndef JAVINO_VERSION_1_ONLY
    if ((stop && *p == START) || (!d->position && held < stop && p[held] == START))
        return held ? JAVINO_FOLLOWS_HEADER : read_frame2(d, p, stop);
    if (!d->quiet && !held && stop)
        return JAVINO_FOLLOWS_OTHER;
#endif
    for (;;) {
        uint16_t next = held + d->position;
        if (d->position >= HEADER) {
            uint16_t whole = HEADER + d->length;
            if (held || d->position == whole)
                return JAVINO_FOLLOWS_HEADER;
            if (whole > d->size - HEADER || (d->gap && whole > stop))
                return JAVINO_FOLLOWS_OTHER; /* It could never arrive whole, with what follows it. */
        }
        if (d->work == 0)
            return JAVINO_FOLLOWS_UNKNOWN;
        d->work--;
        if (next == stop)
            return !d->gap ? JAVINO_FOLLOWS_UNKNOWN : d->position ? JAVINO_FOLLOWS_OTHER : JAVINO_FOLLOWS_HEADER;
        if (!read_byte(d, p[next]))
            return JAVINO_FOLLOWS_OTHER;
        d->position++;
    }
}

/* Drops bytes from the front, which are then of no frame. */
static JAVINO_OUTLINE void drop(javino_decoder *d, uint16_t count)
{
    d->held = 0;
    d->end -= count;
    if (d->gap) {
        d->gap -= count;
        if (!d->gap)
            d->quiet = true;
    }
    if (!d->quiet)
        d->position = 0;
}

bool javino_decoder_next(javino_decoder *decoder, uint16_t now_ms, javino_frame *frame)
{
    javino_decoder *d = decoder;
    uint8_t *p = d->bytes;
    javino_follows read;
    javino_decoder_idle(d, now_ms);
    d->work = JAVINO_WORK;
    while ((read = read_on(d, p)) != JAVINO_FOLLOWS_UNKNOWN) {
        uint16_t step = d->held;
        if (read == JAVINO_FOLLOWS_OTHER) {
            step = IS_FRAME_2(p) ? d->position : 1;
            d->position = 0;
            if (d->session)
                d->quiet = false;
        } else if (!step) {
            break;
        }
        drop(d, step);
        p += step;
    }
    if (p != d->bytes)
        memmove(d->bytes, p, d->end);
    if (read == JAVINO_FOLLOWS_UNKNOWN)
        return false;
    p = d->bytes;
    d->held = d->position;
    d->position = 0;
    frame->payload = p + HEADER;
    frame->length = d->length;
    frame->version = 1;
#ifndef JAVINO_VERSION_1_ONLY
    if (IS_FRAME_2(p)) {
        frame->payload = p + PAYLOAD_AT;
        frame->version = 2;
        frame->kind = p[KIND_AT];
        frame->number = p[NUMBER_AT];
    }
    if (d->session)
        d->quiet = false;
#endif
    return true;
}

javino_follows javino_decoder_follows(javino_decoder *decoder, uint16_t now_ms)
{
    javino_follows read;
    if (!decoder->held)
        return JAVINO_FOLLOWS_UNKNOWN;
    decoder->work = JAVINO_WORK;
    read = read_on(decoder, decoder->bytes);
    if (read == JAVINO_FOLLOWS_UNKNOWN && elapsed(now_ms, decoder->last_ms) > decoder->timeout_ms / 16)
        return decoder->position ? JAVINO_FOLLOWS_OTHER : JAVINO_FOLLOWS_HEADER;
    return read;
}

/* ---- Encoder ---- */

static void put_plain(javino_encoder *e, uint8_t byte)
{
    e->write(e->context, byte);
}

static void put_digit(javino_encoder *e, uint8_t digit)
{
    put_plain(e, (uint8_t)(digit + (digit < 10 ? '0' : 'A' - 10)));
}

void javino_encoder_begin(javino_encoder *encoder, uint8_t length)
{
    encoder->version2 = false;
    javino_encoder_finish(encoder, "fffe", 4);
    put_digit(encoder, length >> 4);
    put_digit(encoder, length & 0x0F);
}

#ifdef JAVINO_VERSION_1_ONLY

void javino_encoder_put(javino_encoder *encoder, uint8_t byte)
{
    put_plain(encoder, byte);
}

#else

void javino_encoder_begin2(javino_encoder *encoder, uint8_t kind, uint8_t number, uint8_t length)
{
    encoder->version2 = true;
    encoder->crc = JAVINO_CRC_START;
    put_plain(encoder, START);
    javino_encoder_put(encoder, length);
    javino_encoder_put(encoder, kind);
    javino_encoder_put(encoder, number);
}

void javino_encoder_put(javino_encoder *encoder, uint8_t byte)
{
    encoder->crc = javino_crc16(encoder->crc, byte);
    if (encoder->version2 && (byte == START || byte == ESCAPE)) {
        put_plain(encoder, ESCAPE);
        byte ^= ESCAPED;
    }
    put_plain(encoder, byte);
}

#endif

JAVINO_NOINLINE void javino_encoder_finish(javino_encoder *encoder, const char *text, uint8_t length)
{
    while (length--)
        javino_encoder_put(encoder, (uint8_t)*text++);
#ifndef JAVINO_VERSION_1_ONLY
    if (encoder->version2) {
        uint16_t crc = encoder->crc;
        javino_encoder_put(encoder, (uint8_t)(crc >> 8));
        javino_encoder_put(encoder, (uint8_t)crc);
    }
#endif
}

void javino_encoder_end(javino_encoder *encoder)
{
    javino_encoder_finish(encoder, NULL, 0);
}
