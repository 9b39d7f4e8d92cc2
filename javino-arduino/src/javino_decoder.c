#include "javino_decoder.h"

#include <string.h>

#define HEADER JAVINO_PAYLOAD_AT_1
#define NO_DIGIT 16

#ifdef JAVINO_VERSION_1_ONLY
#define IS_FRAME_2(bytes) false
#else
#define IS_FRAME_2(bytes) (*(bytes) == JAVINO_START)
#endif

#ifndef JAVINO_VERSION_2_ONLY
static uint8_t digit_value(uint8_t c)
{
    c = (uint8_t)(c - '0');
    if (c < 10)
        return c;
    c = (uint8_t)((c | 0x20) - ('a' - '0')); /* for upper and lower case */
    return c < 6 ? c + 10 : NO_DIGIT;
}
#endif

/* Returns the milliseconds since `was`. Returns 0 if `was` is later than `now`: a byte may have come after the caller read the clock. */
static uint16_t elapsed(uint16_t now, uint16_t was)
{
    now -= was;
    return now < 0x8000u ? now : 0;
}

bool javino_decoder_init(javino_decoder *decoder, uint8_t *bytes, uint16_t size, uint16_t timeout_ms)
{
    memset(decoder, 0, sizeof *decoder);
    decoder->bytes = bytes;
    decoder->size = size;
    decoder->timeout_ms = timeout_ms;
    decoder->quiet = true;
    return size >= 2 * HEADER;
}

/* While there is no room, unread bytes of unknown age may be waiting, so a silence does not count. While a frame is delivered but not
 * confirmed, the line may fall silent twice. The first silence is kept, because the bytes before it have waited longer. */
JAVINO_OUTLINE void javino_decoder_idle(javino_decoder *decoder, uint16_t now_ms)
{
    javino_decoder *d = decoder;
    uint16_t silence;
    if (d->end >= d->size)
        d->last_ms = now_ms;
    d->silence = silence = elapsed(now_ms, d->last_ms);
#ifndef JAVINO_VERSION_1_ONLY
    if (d->end == d->taken && silence > d->timeout_ms / 4)
        d->quiet = true;
#endif
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

void javino_decoder_session(javino_decoder *decoder, uint8_t nonce)
{
    decoder->session = nonce;
    decoder->quiet = !nonce;
}

#ifndef JAVINO_VERSION_1_ONLY

/* Returns true if computers send frames of this kind. */
static bool is_kind(uint8_t kind)
{
    switch (kind) {
    case JAVINO_HELLO:
    case JAVINO_ASK:
    case JAVINO_DESCRIBE:
    case JAVINO_COMMANDS:
    case JAVINO_RESUME: return true;
    default: return false;
    }
}

/* The CRC of data followed by its CRC is zero. */
static bool is_intact(const javino_decoder *d, const uint8_t *frame, const uint8_t *end)
{
    uint8_t nonce = 0;
    uint16_t crc;
    if (frame[JAVINO_KIND_AT] != JAVINO_HELLO) {
        nonce = d->session;
        if (!nonce)
            return true;
    }
    crc = JAVINO_CRC_START(nonce);
    while (++frame < end)
        crc = javino_crc16(crc, *frame);
    return crc == 0;
}

/**
 * Continues to read the frame of version 2 at p, up to the last byte that has come. Removes the escapes. FOLLOWS_HEADER: the frame is
 * complete. FOLLOWS_OTHER: the frame is damaged, and ends at or before the byte that shows the damage.
 */
static javino_follows read_frame2(javino_decoder *d, uint8_t *p, const uint8_t *end)
{
    uint8_t *out = p + d->taken;
    const uint8_t *in = out;
    javino_follows read = JAVINO_FOLLOWS_UNKNOWN;
    while (in < end) {
        uint16_t place = (uint16_t)(out - p);
        bool escaped = *in == JAVINO_ESCAPE;
        uint8_t c;
        if (escaped && in + 1 == end)
            break;
        c = in[escaped];
        read = JAVINO_FOLLOWS_OTHER;
        if (c == JAVINO_START && place)
            break;
        in += escaped + 1;
        if (escaped) {
            c ^= JAVINO_ESCAPED;
            if ((c & 0xFE) != JAVINO_ESCAPE)
                break;
        }
        *out++ = c;
        if (place == JAVINO_LENGTH_AT) {
            if (c >= d->size - JAVINO_OVERHEAD)
                break;
        } else if (place == JAVINO_KIND_AT) {
            if (!is_kind(c))
                break;
        } else if (place && place == (uint16_t)(p[JAVINO_LENGTH_AT] + JAVINO_OVERHEAD - 1)) {
            if (is_intact(d, p, out))
                read = JAVINO_FOLLOWS_HEADER;
            break;
        }
        read = JAVINO_FOLLOWS_UNKNOWN;
    }
    d->taken = (uint16_t)(out - p);
    memmove(out, in, (size_t)(p + d->end - in));
    d->end -= (uint16_t)(in - out);
    if (d->gap) {
        d->gap -= (uint16_t)(in - out);
        if (read == JAVINO_FOLLOWS_UNKNOWN)
            read = JAVINO_FOLLOWS_OTHER;
    }
    return read;
}
#endif

#ifndef JAVINO_VERSION_2_ONLY
/* Reads the header of a frame of version 1 and the length of its payload. FOLLOWS_UNKNOWN: there are too few bytes. */
static javino_follows read_header(const uint8_t *p, const uint8_t *end, uint8_t *length)
{
    uint8_t i;
    *length = 0;
    for (i = 0; i < HEADER; i++) {
        uint8_t c;
        if (p == end)
            return JAVINO_FOLLOWS_UNKNOWN;
        c = *p++;
        if (i < sizeof javino_preamble) {
            if (c != (uint8_t)javino_preamble[i])
                return JAVINO_FOLLOWS_OTHER;
        } else {
            c = digit_value(c);
            if (c == NO_DIGIT)
                return JAVINO_FOLLOWS_OTHER;
            *length = (uint8_t)(*length << 4) | c;
        }
    }
    return JAVINO_FOLLOWS_HEADER;
}
#endif

/* Continues to read, up to the last byte that has come. FOLLOWS_HEADER: a frame is complete. If a frame is held, a header or silence
 * follows it. FOLLOWS_OTHER: the bytes are no frame. FOLLOWS_UNKNOWN: more bytes are needed. */
static JAVINO_NOINLINE javino_follows read_on(javino_decoder *d, uint8_t *p)
{
    uint16_t stop = d->gap ? d->gap : d->end;
    const uint8_t *end = p + stop;
    const uint8_t *next = p;
#ifndef JAVINO_VERSION_2_ONLY
    uint8_t length;
    javino_follows read;
#endif
    if (d->held) {
        if (IS_FRAME_2(p))
            return JAVINO_FOLLOWS_HEADER;
        next += d->taken;
    }
    if (next == end)
        return d->gap ? JAVINO_FOLLOWS_HEADER : JAVINO_FOLLOWS_UNKNOWN;
#ifndef JAVINO_VERSION_1_ONLY
    if (IS_FRAME_2(next))
        return d->held ? JAVINO_FOLLOWS_HEADER : read_frame2(d, p, end);
#endif
#ifdef JAVINO_VERSION_2_ONLY
    return JAVINO_FOLLOWS_OTHER;
#else
#ifndef JAVINO_VERSION_1_ONLY
    if (!d->quiet && !d->held)
        return JAVINO_FOLLOWS_OTHER;
#endif
    read = read_header(next, end, &length);
    if (read == JAVINO_FOLLOWS_HEADER && !d->held) {
        uint16_t whole = HEADER + length;
        if (whole > d->size - HEADER)
            return JAVINO_FOLLOWS_OTHER; /* The memory has no room for this frame and the next header. */
        if (whole <= stop)
            d->taken = whole;
        else
            read = JAVINO_FOLLOWS_UNKNOWN;
    }
    return read == JAVINO_FOLLOWS_UNKNOWN && d->gap ? JAVINO_FOLLOWS_OTHER : read;
#endif
}

JAVINO_OUTLINE const uint8_t *javino_decoder_next(javino_decoder *decoder, uint16_t now_ms)
{
    javino_decoder *d = decoder;
    uint8_t *p = d->bytes;
    javino_follows read;
    javino_decoder_idle(d, now_ms);
    while ((read = read_on(d, p)) == JAVINO_FOLLOWS_OTHER || (read && d->held)) {
        uint16_t step = d->taken;
        if (read == JAVINO_FOLLOWS_OTHER) {
            if (!IS_FRAME_2(p))
                step = 1;
#ifndef JAVINO_VERSION_1_ONLY
            else
                d->damaged++;
            if (d->session)
                d->quiet = false;
#endif
        }
        d->held = false;
        d->taken = 0;
        p += step;
        d->end -= step;
        if (d->gap) {
            d->gap -= step;
#ifndef JAVINO_VERSION_1_ONLY
            if (!d->gap)
                d->quiet = true;
#endif
        }
    }
    memmove(d->bytes, p, d->end);
    if (read == JAVINO_FOLLOWS_UNKNOWN)
        return NULL;
    d->held = true;
#ifndef JAVINO_VERSION_1_ONLY
    if (d->session)
        d->quiet = false;
#endif
    return d->bytes;
}

javino_follows javino_decoder_follows(javino_decoder *decoder, uint16_t now_ms)
{
    javino_decoder *d = decoder;
    javino_follows read;
    if (!d->held)
        return JAVINO_FOLLOWS_UNKNOWN;
    javino_decoder_idle(d, now_ms);
    read = read_on(d, d->bytes);
    if (read == JAVINO_FOLLOWS_UNKNOWN && d->silence > d->timeout_ms / 16)
        return d->end > d->taken ? JAVINO_FOLLOWS_OTHER : JAVINO_FOLLOWS_HEADER;
    return read;
}
