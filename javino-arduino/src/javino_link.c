#include "javino_link.h"

#include <string.h>

#ifndef JAVINO_VERSION_2_ONLY
#define REQUEST_LENGTH 11 /* length of getPercepts */
#endif

/* The most frames for one poll. A flood of frames then cannot block the program. */
#define FRAMES_PER_POLL 8

/* Number of checksum bytes after a payload. */
#define CRC_LENGTH 2

/* The first bytes of items in a row of commands. */
#define LONG_TEXT 0x00
#define BY_NUMBER 0x80
#define NO_COMMAND 0xFE
#define RULE 0xFF

void javino_link_init(javino_link *link, void *bytes, uint16_t size, javino_write write, void *context)
{
    memset(link, 0, sizeof *link);
    /* Not javino_decoder_init, because it would clear the decoder again. */
    link->decoder.bytes = (uint8_t *)bytes;
    link->decoder.size = size;
    link->decoder.timeout_ms = 100;
    link->decoder.quiet = true;
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

#ifndef JAVINO_VERSION_2_ONLY
void javino_link_send(javino_link *link, const char *text, uint8_t length)
{
    link->answered = true;
    javino_encoder_begin(&link->encoder, length);
    javino_encoder_finish(&link->encoder, text, length);
}
#endif

/* ---- Version 2 ---- */

#ifndef JAVINO_VERSION_1_ONLY

void javino_link_begin(javino_link *link, uint8_t kind, uint8_t length)
{
    javino_encoder_begin2(&link->encoder, kind == JAVINO_WELCOME ? 0 : link->session, kind | link->flags, link->due, length);
}

static void put(javino_link *l, uint8_t byte)
{
    javino_encoder_put(&l->encoder, byte);
}

static void send(javino_link *l, uint8_t kind, const uint8_t *payload, uint8_t length)
{
    javino_link_begin(l, kind, length);
    javino_encoder_finish(&l->encoder, (const char *)payload, length);
}

static void acknowledge(javino_link *l)
{
    send(l, JAVINO_ACK, NULL, 0);
}

/* Ends the next command in order. */
static void settle(javino_link *l, bool done)
{
    l->due++;
    l->flags = done ? 0 : JAVINO_REFUSED;
}

static JAVINO_NOINLINE void welcome(javino_link *l)
{
    uint16_t room = l->decoder.size - JAVINO_OVERHEAD - 1;
    l->credit = JAVINO_CREDIT;
    l->longest = room < JAVINO_MAX_PAYLOAD ? (uint8_t)room : JAVINO_MAX_PAYLOAD;
    l->revision = JAVINO_REVISION;
    send(l, JAVINO_WELCOME, &l->session, 6);
}

/* Begins a session. If the nonce is 0, ends the present session. */
static JAVINO_NOINLINE void begin_session(javino_link *l, uint8_t nonce)
{
    l->session = nonce;
    memset(&l->due, 0, 5); /* also clears flags, known, shapes and rules */
    javino_decoder_session(&l->decoder, nonce);
}

/* `actions` is stored newest first. Number 0 is the oldest action. */
static JAVINO_NOINLINE const javino_action *action_at(const javino_link *l, uint8_t number)
{
    return (const javino_action *)((const char *)l->actions + l->action_size * (uint8_t)(l->action_count - 1 - number));
}

/* Sends as many actions from `first` on as a frame holds. */
static void describe(javino_link *l, uint8_t request, uint8_t first)
{
    uint8_t length = 3;
    uint8_t end;
    for (end = first; end < l->action_count; end++) {
        uint8_t bytes = (uint8_t)strlen(action_at(l, end)->name) + 2;
        uint8_t room = JAVINO_MAX_PAYLOAD - length;
        if (bytes > room)
            break;
        length += bytes;
    }
    javino_link_begin(l, JAVINO_VOCABULARY, length);
    put(l, request);
    put(l, first);
    put(l, l->action_count);
    for (; first < end; first++) {
        const javino_action *action = action_at(l, first);
        const char *name = action->name;
        put(l, action->arguments);
        put(l, (uint8_t)strlen(name));
        while (*name)
            put(l, (uint8_t)*name++);
    }
    javino_encoder_end(&l->encoder);
}

/* Returns the next command of the frame. At the end of the frame, acknowledges its commands. */
static javino_event next_command(javino_link *l)
{
    uint8_t *frame = l->decoder.bytes;
    const uint8_t *end = frame + l->decoder.taken - CRC_LENGTH;
    for (;;) {
        uint8_t left = frame[JAVINO_LENGTH_AT];
        const uint8_t *p = end - left;
        uint8_t length = 0;
        uint8_t head;
        if (!left)
            break;
        head = *p++;
        left--;
        if (head < BY_NUMBER || head == RULE) {
            length = head;
            if (head == RULE || head == LONG_TEXT) {
                if (!left)
                    break;
                length = *p++;
                left--;
            }
            if (length == 0 || length > left)
                break;
        }
        frame[JAVINO_LENGTH_AT] = left - length;
        if (frame[JAVINO_NUMBER_AT]++ != l->due || l->flags) // the command was carried out before, or is out of order
            continue;
        l->text = (const char *)p;
        l->length = length;
        if (head < BY_NUMBER)
            return JAVINO_ACTION;
        if (head == RULE && l->rules_max)
            return JAVINO_RULE;
        if ((uint8_t)(head - BY_NUMBER) < l->action_count) {
            l->text = action_at(l, head - BY_NUMBER)->name;
            l->length = (uint8_t)strlen(l->text);
            return JAVINO_ACTION;
        }
        settle(l, head == NO_COMMAND);
    }
    l->row = false;
    acknowledge(l);
    return JAVINO_NOTHING;
}

/* Handles a frame of version 2. Returns the event for the program. */
static javino_event meaning2(javino_link *l, const uint8_t *frame)
{
    uint8_t length = frame[JAVINO_LENGTH_AT];
    uint8_t kind = frame[JAVINO_KIND_AT];
    uint8_t number = frame[JAVINO_NUMBER_AT];
    const uint8_t *payload = frame + JAVINO_PAYLOAD_AT;
    uint8_t first = length ? *payload : 0;
    if (kind == JAVINO_HELLO) {
        if (number != l->session) /* a repeated HELLO begins no new session */
            begin_session(l, number);
        welcome(l);
    } else if (!l->session) {
        welcome(l);
    } else if (kind == JAVINO_DESCRIBE) {
        describe(l, number, first);
    } else if (kind == JAVINO_ASK) {
        l->request = number;
        l->known = first < l->shapes ? first : l->shapes;
        l->text = (const char *)payload + 1;
        l->length = length ? length - 1 : 0;
        return JAVINO_REQUEST;
    } else {
        l->row = true;
        if (kind == JAVINO_RESUME && number == l->due)
            l->flags &= (uint8_t)~JAVINO_REFUSED;
    }
    return JAVINO_NOTHING;
}

#endif

/* ---- Both versions ---- */

/* Returns the event for the program that a new frame causes. */
static javino_event meaning(javino_link *l, const uint8_t *frame)
{
#ifndef JAVINO_VERSION_2_ONLY
    const uint8_t n = REQUEST_LENGTH;
#endif
    l->answered = false;
    l->heard = true;
    l->frames++;
#ifndef JAVINO_VERSION_1_ONLY
    if (*frame == JAVINO_START)
        return meaning2(l, frame);
#endif
#ifdef JAVINO_VERSION_2_ONLY
    return JAVINO_NOTHING;
#else
#ifndef JAVINO_VERSION_1_ONLY
    begin_session(l, 0); /* A computer that speaks version 1 has no session. */
#endif
    l->text = (const char *)frame + JAVINO_PAYLOAD_AT_1;
    l->length = (uint8_t)(l->decoder.taken - JAVINO_PAYLOAD_AT_1);
    if (l->length < n || memcmp(l->text, "getPercepts", n) != 0 || (l->length > n && l->text[n] != '('))
        return JAVINO_ACTION;
    l->text += n;
    l->length -= n;
    return JAVINO_REQUEST;
#endif
}

JAVINO_NOINLINE void javino_link_finish(javino_link *link, bool done)
{
    bool action = link->event >= JAVINO_ACTION;
    link->event = JAVINO_NOTHING;
#ifdef JAVINO_VERSION_1_ONLY
    (void)action;
    (void)done;
#else
    if (action && JAVINO_IS_2(link))
        settle(link, done);
    link->request = 0;
#endif
}

javino_later javino_link_later(javino_link *link)
{
#ifdef JAVINO_VERSION_1_ONLY
    (void)link;
    return 0;
#else
    if (link->event != JAVINO_ACTION || !JAVINO_IS_2(link))
        return 0;
    link->event = JAVINO_NOTHING;
    link->flags = JAVINO_BUSY;
    if (++link->later == 0)
        link->later++;
    return link->later;
#endif
}

bool javino_link_done(javino_link *link, javino_later later, bool done)
{
#ifdef JAVINO_VERSION_1_ONLY
    (void)link;
    (void)later;
    (void)done;
    return false;
#else
    if (!(link->flags & JAVINO_BUSY) || later != link->later)
        return false;
    settle(link, done);
    acknowledge(link);
    return true;
#endif
}

javino_event javino_link_poll(javino_link *link, uint16_t now_ms)
{
    javino_link *l = link;
    bool all_handed_in = javino_decoder_ready(&l->decoder);
    uint8_t frames = FRAMES_PER_POLL;
    const uint8_t *frame;
    javino_link_finish(l, true);
    l->drained = false;
    for (;;) {
#ifndef JAVINO_VERSION_1_ONLY
        if (l->row)
            l->event = next_command(l);
#endif
        if (l->event != JAVINO_NOTHING || !frames--)
            break;
        frame = javino_decoder_next(&l->decoder, now_ms);
        if (!frame) {
            l->drained = all_handed_in;
            break;
        }
        l->event = meaning(l, frame);
    }
    return l->event;
}

JAVINO_OUTLINE void javino_link_supervise(javino_link *link, uint32_t now_ms)
{
    link->heard = link->lost = false;
    link->since_ms = link->drained_ms = now_ms;
}

JAVINO_NOINLINE bool javino_link_lost(javino_link *link, uint32_t silence_ms, uint32_t now_ms)
{
    if (link->heard) {
        /* The message may have waited since the receive buffer was last empty. */
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
