#include "javino_core.h"

#include <string.h>

#define HEADER 6 /* bytes of preamble and size */
#define CRC 4
/* Version 2 has two digits more in front of its payload, and four behind it. */
#define FRONT(version) (uint8_t)(HEADER - 2 + 2 * (version))
#define AROUND(version) (uint8_t)(HEADER * (version))
#define NO_DIGIT 16

/* A repeated action is an echo of the last one only for so long: a far end that was started anew may come to
 * the same sequence number with an action of its own. */
#define REPEAT_MS 3000

/* An outcome that is not known yet: the action goes on. */
#define PENDING JAVINO_MORE

/* A frame that began behind so many bytes of whole frames is not inside the text of a damaged one. */
#define SETTLED JAVINO_MAX_PAYLOAD

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
    crc = (uint16_t)(crc << 8 | crc >> 8) ^ byte;
    crc ^= (uint8_t)crc >> 4;
    crc ^= (uint16_t)(crc << 12);
    crc ^= (uint16_t)((crc & 0xFFu) << 5);
    return crc;
}

/* ---- Decoder ---- */

/* The milliseconds that have passed; none if was is in the future: a byte may have come while the caller's now was growing
 * old. */
static uint16_t elapsed(uint16_t now, uint16_t was)
{
    now -= was;
    return now < 0x8000u ? now : 0;
}

/* Prepares a decoder that is all zero. */
static JAVINO_OUTLINE void set_up(javino_decoder *decoder, uint8_t *bytes, uint16_t size, uint16_t timeout_ms)
{
    decoder->bytes = bytes;
    decoder->size = size;
    decoder->timeout_ms = timeout_ms;
}

bool javino_decoder_init(javino_decoder *decoder, uint8_t *bytes, uint16_t size, uint16_t timeout_ms)
{
    memset(decoder, 0, sizeof *decoder);
    set_up(decoder, bytes, size, timeout_ms);
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
        d->settled = SETTLED;
    if (!d->gap && silence > d->timeout_ms)
        d->gap = d->end;
}

bool javino_decoder_ready(const javino_decoder *decoder)
{
    return decoder->end < decoder->size;
}

JAVINO_OUTLINE void javino_decoder_put(javino_decoder *decoder, uint8_t byte, uint16_t now_ms)
{
    decoder->bytes[decoder->end++] = byte;
    decoder->last_ms = now_ms;
}

/* Reads the next byte of a frame; false if it cannot stand there. */
static JAVINO_OUTLINE bool read_byte(javino_decoder *d, uint8_t c)
{
    javino_frame *f = &d->read;
    uint16_t position = d->position;
    uint8_t value = digit_value(c);
    if (position < 3)
        return c == 'f';
    if (position == 3) {
        f->crc = JAVINO_CRC_START;
        f->control = 0;
        f->version = 'f' - c;
        return c == 'e' || c == 'd';
    }
    if (position < FRONT(f->version)) {
        uint8_t *two = position < HEADER ? &f->length : &f->control;
        *two = (uint8_t)(*two << 4) | value;
        if (value == NO_DIGIT)
            return false;
        d->whole = f->length + AROUND(f->version);
    } else if (f->version == 2 && position >= d->whole - CRC) {
        uint8_t expected = f->crc >> 12;
        f->crc = (uint16_t)(f->crc << 4) | expected;
        return value == expected;
    }
    f->crc = javino_crc16(f->crc, c);
    return true;
}

/* Reads on as far as the bytes go. FOLLOWS_HEADER: a whole frame or, behind a frame that is held, a header or
 * silence; FOLLOWS_OTHER: the bytes make no frame; FOLLOWS_UNKNOWN: there are no more yet. */
static JAVINO_OUTLINE javino_follows read_on(javino_decoder *d, const uint8_t *p)
{
    uint16_t stop = d->gap ? d->gap : d->end;
    while (d->position < HEADER || (!d->held && d->position < d->whole)) {
        uint16_t next = d->held + d->position;
        if (d->position >= HEADER && (d->whole > d->size - HEADER || (d->gap && d->whole > stop)))
            return JAVINO_FOLLOWS_OTHER; /* It could never arrive whole, with what follows it. */
        if (d->work == 0)
            return JAVINO_FOLLOWS_UNKNOWN;
        d->work--;
        if (next == stop)
            return !d->gap ? JAVINO_FOLLOWS_UNKNOWN : d->position ? JAVINO_FOLLOWS_OTHER : JAVINO_FOLLOWS_HEADER;
        if (!read_byte(d, p[next]))
            return JAVINO_FOLLOWS_OTHER;
        d->position++;
    }
    return JAVINO_FOLLOWS_HEADER;
}

/* As javino_decoder_next, as long as there is work left. */
static JAVINO_OUTLINE bool look(javino_decoder *d, uint16_t now_ms, javino_frame *frame)
{
    const uint8_t *p = d->bytes;
    javino_follows read;
    javino_decoder_idle(d, now_ms);
    while ((read = read_on(d, p)) != JAVINO_FOLLOWS_UNKNOWN) {
        uint16_t step = d->held;
        uint16_t settled = d->settled + step;
        if (read == JAVINO_FOLLOWS_OTHER) {
            d->position = settled = 0;
            step = 1;
        } else if (!step) {
            break;
        }
        d->held = 0;
        d->end -= step;
        p += step;
        if (d->gap) {
            d->gap -= step;
            if (!d->gap)
                settled = SETTLED;
        }
        d->settled = settled > SETTLED ? SETTLED : (uint8_t)settled;
    }
    if (p != d->bytes)
        memmove(d->bytes, p, d->end);
    if (read == JAVINO_FOLLOWS_UNKNOWN)
        return false;
    d->held = d->whole;
    d->position = 0;
    d->read.payload = d->bytes + FRONT(d->read.version);
    d->read.clean = d->settled == SETTLED;
    *frame = d->read;
    return true;
}

bool javino_decoder_next(javino_decoder *decoder, uint16_t now_ms, javino_frame *frame)
{
    decoder->work = JAVINO_WORK;
    return look(decoder, now_ms, frame);
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

JAVINO_OUTLINE void javino_encoder_put(javino_encoder *encoder, uint8_t byte)
{
    encoder->crc = javino_crc16(encoder->crc, byte);
    encoder->write(encoder->context, byte);
}

/* Two hex digits, of which ten is this letter. */
static void put_digits(javino_encoder *e, uint8_t value, uint8_t ten)
{
    uint8_t i;
    for (i = 0; i < 2; i++) {
        uint8_t digit = value >> 4;
        javino_encoder_put(e, (uint8_t)(digit + (digit < 10 ? '0' : ten - 10)));
        value = (uint8_t)(value << 4);
    }
}

void javino_encoder_begin(javino_encoder *encoder, uint8_t version, uint8_t control, uint8_t length)
{
    encoder->version = version;
    put_digits(encoder, 0xFF, 'a');
    put_digits(encoder, version == 2 ? 0xFD : 0xFE, 'a');
    encoder->crc = JAVINO_CRC_START;
    put_digits(encoder, length, 'A');
    if (version == 2)
        put_digits(encoder, control, 'A');
}

void javino_encoder_end(javino_encoder *encoder)
{
    uint16_t crc = encoder->crc;
    if (encoder->version == 2) {
        put_digits(encoder, (uint8_t)(crc >> 8), 'A');
        put_digits(encoder, (uint8_t)crc, 'A');
    }
}

/* ---- Link ---- */

void javino_link_init(javino_link *link, void *bytes, uint16_t size, javino_write write, void *context)
{
    memset(link, 0, sizeof *link);
    set_up(&link->decoder, (uint8_t *)bytes, size, 100);
    link->encoder.write = write;
    link->encoder.context = context;
}

void javino_link_timeout(javino_link *link, uint16_t timeout_ms)
{
    link->decoder.timeout_ms = timeout_ms;
}

bool javino_link_ready(const javino_link *link)
{
    return javino_decoder_ready(&link->decoder);
}

void javino_link_receive(javino_link *link, uint8_t byte, uint16_t now_ms)
{
    javino_decoder_put(&link->decoder, byte, now_ms);
}

static JAVINO_OUTLINE void send_frame(javino_link *l, uint8_t version, uint8_t control, const char *text, uint8_t length)
{
    javino_encoder_begin(&l->encoder, version, control, length);
    while (length--)
        javino_encoder_put(&l->encoder, (uint8_t)*text++);
    javino_encoder_end(&l->encoder);
}

JAVINO_OUTLINE void javino_link_send(javino_link *link, uint8_t flags, const char *text, uint8_t length)
{
    link->answered = true;
    send_frame(link, link->frame.version, flags | link->sequence, text, length);
    link->sequence = (link->sequence + 1) & JAVINO_SEQUENCE;
}

/* Reports the outcome of the action with this control byte, if the far end wants to know and it is known. */
static JAVINO_OUTLINE void acknowledge(javino_link *l, uint8_t control, uint8_t outcome)
{
    if (control & JAVINO_ACK_WANTED && outcome != PENDING)
        send_frame(l, 2, outcome | (control & JAVINO_SEQUENCE), NULL, 0);
}

/* Remembers the frame in hand and its outcome, for when it is repeated. */
static JAVINO_OUTLINE void settle(javino_link *l, uint8_t outcome)
{
    l->acted_crc = l->frame.crc;
    l->acted_control = l->frame.control;
    l->acted_outcome = outcome;
    l->untimed = true;
    acknowledge(l, l->frame.control, outcome);
}

static bool is_request(const javino_frame *f)
{
    const uint8_t n = JAVINO_REQUEST_LENGTH;
    return f->length >= n && memcmp(f->payload, "getPercepts", n) == 0 && (f->length == n || f->payload[n] == '(');
}

/* What the frame that has just arrived means to the program. */
static JAVINO_OUTLINE javino_event meaning(javino_link *l)
{
    const javino_frame *f = &l->frame;
    if (f->control & (JAVINO_ACK | JAVINO_REFUSAL))
        return JAVINO_NOTHING;
    if (f->version == 2) {
        l->version2 = true;
        if (l->acted_outcome && f->crc == l->acted_crc && !((f->control ^ l->acted_control) & JAVINO_SEQUENCE)) {
            acknowledge(l, f->control, l->acted_outcome);
            return JAVINO_NOTHING;
        }
        if (f->clean) {
            /* The parts of a message count on. No message to a board is that long, and a part of one must not be taken
             * for an action. */
            bool part = l->part & JAVINO_MORE && (uint8_t)((uint8_t)(f->control - l->part) << 4) == 0x10;
            l->part = f->control;
            if (part || f->control & JAVINO_MORE) {
                settle(l, JAVINO_REFUSAL);
                return JAVINO_NOTHING;
            }
        }
    }
    if (is_request(f))
        return JAVINO_REQUEST;
    /* Among the ruins of a version 2 frame, what looks like a frame may have been its text. */
    return l->version2 && !f->clean ? JAVINO_NOTHING : JAVINO_ACTION;
}

/* Ends the message in hand with this outcome. */
static JAVINO_OUTLINE void finish(javino_link *l, uint8_t outcome)
{
    bool action = l->event == JAVINO_ACTION;
    bool any = l->event != JAVINO_NOTHING;
    l->event = JAVINO_NOTHING;
    if (!any || l->frame.version != 2)
        return;
    if (action)
        settle(l, outcome);
    else
        acknowledge(l, l->frame.control, outcome);
}

void javino_link_finish(javino_link *link, bool done)
{
    finish(link, done ? JAVINO_ACK : JAVINO_REFUSAL);
}

javino_later javino_link_later(javino_link *link)
{
    if (link->event != JAVINO_ACTION || link->frame.version != 2)
        return 0;
    finish(link, PENDING);
    if (++link->later == 0)
        link->later++;
    return link->later;
}

bool javino_link_done(javino_link *link, javino_later later, bool done)
{
    if (link->acted_outcome != PENDING || later != link->later)
        return false;
    link->acted_outcome = done ? JAVINO_ACK : JAVINO_REFUSAL;
    link->untimed = true;
    acknowledge(link, link->acted_control, link->acted_outcome);
    return true;
}

javino_event javino_link_poll(javino_link *link, uint16_t now_ms)
{
    javino_decoder *d = &link->decoder;
    bool all_handed_in = d->end < d->size;
    finish(link, JAVINO_ACK);
    d->work = JAVINO_WORK;
    while (link->event == JAVINO_NOTHING && look(d, now_ms, &link->frame)) {
        link->heard = true;
        link->answered = false;
        link->event = meaning(link);
    }
    link->drained = false;
    if (all_handed_in && d->work && link->event == JAVINO_NOTHING) {
        link->drained = true;
        /* A repetition may have waited as long as the program was busy, so what waited has been read first. */
        if (link->untimed)
            link->acted_ms = now_ms;
        else if (elapsed(now_ms, link->acted_ms) > REPEAT_MS)
            link->acted_outcome = 0;
        link->untimed = link->acted_outcome == PENDING;
    }
    return link->event;
}

void javino_link_supervise(javino_link *link, uint32_t now_ms)
{
    link->heard = link->lost = false;
    link->since_ms = link->drained_ms = now_ms;
}

bool javino_link_lost(javino_link *link, uint32_t silence_ms, uint32_t now_ms)
{
    if (link->heard) {
        /* It may have waited since the receive buffer was empty. */
        link->heard = link->lost = false;
        link->since_ms = link->drained_ms;
    }
    if (link->drained)
        link->drained_ms = now_ms;
    if (link->lost || now_ms - link->since_ms <= silence_ms)
        return false;
    link->lost = true;
    return true;
}
