/* A board with a small program, and the parts of its core, driven by the records that driven.py explains. */
#include <string.h>

#include "javino_board.h"
#include "javino_rules.h"
#include "stream.h"

/* ---- Answers to records ---- */

static uint8_t sent[12288];
static uint8_t carried[4096];
static uint16_t sent_length, carried_length;

static void reply(void)
{
    stream_write(&sent_length, 2);
    stream_write(sent, sent_length);
    stream_write(&carried_length, 2);
    stream_write(carried, carried_length);
    sent_length = carried_length = 0;
}

static void write_byte(void *context, uint8_t byte)
{
    (void)context;
    if (sent_length == sizeof sent)
        stream_end();
    sent[sent_length++] = byte;
}

static void note_carried(const char *text, uint8_t length)
{
    if (carried_length + length + 1u > sizeof carried)
        stream_end();
    carried[carried_length] = length;
    memcpy(carried + carried_length + 1, text, length);
    carried_length += length + 1u;
}

/* ---- A board ---- */

static uint8_t memory[8192];
static javino_board board;
static javino_later later;
static uint16_t now;
static char percepts[4096]; /* texts without their `;`, each with a zero byte behind */
static uint16_t percepts_length;

static const javino_action actions[] = {{"say", JAVINO_ANY}, {"grip", 0}, {"bump", 0}, {"speed", 1}, {"left", 0}, {"front", 0}};

static bool is(const char *text, uint8_t length, const char *other)
{
    return length == strlen(other) && memcmp(text, other, length) == 0;
}

/* The program: it knows whole texts. Returns false for others. */
static bool carry_out(const char *text, uint8_t length)
{
    bool does = is(text, length, "front") || is(text, length, "left") || is(text, length, "grip") || is(text, length, "say") ||
                (length > 6 && memcmp(text, "speed(", 6) == 0);
    if (does)
        note_carried(text, length);
    return does;
}

static bool react(void *context, const char *text, uint8_t length)
{
    (void)context;
    return carry_out(text, length);
}

static void act(void)
{
    const char *text = board.link.text;
    uint8_t length = board.link.length;
    bool done = carry_out(text, length);
    if (done && is(text, length, "grip"))
        later = javino_link_later(&board.link);
    else
        javino_link_finish(&board.link, done);
}

static void perceive(void *context)
{
    const char *p;
    (void)context;
    for (p = percepts; p < percepts + percepts_length; p += strlen(p) + 1) {
        size_t functor = strcspn(p, "(");
        if (javino_board_wants(&board, p, (uint8_t)functor)) {
            javino_percept_text(&board, p);
            javino_percept_end(&board);
        }
    }
}

static void answer(void)
{
    perceive(NULL);
    javino_board_answer(&board);
}

static void poll(void)
{
    javino_event event;
    uint8_t quiet = 0;
    /* A poll handles only some frames, or sends one part of an answer, and then hands nothing out. */
    while (quiet < 3) {
        event = javino_board_poll(&board, now);
        quiet = event == JAVINO_NOTHING && !board.answering ? quiet + 1 : 0;
        if (event == JAVINO_REQUEST)
            answer();
        else if (event == JAVINO_ACTION)
            act();
    }
}

static void receive(const uint8_t *bytes, uint16_t length)
{
    javino_decoder_idle(&board.link.decoder, now);
    poll();
    while (length--) {
        if (!javino_link_ready(&board.link))
            stream_end();
        javino_link_receive(&board.link, *bytes++, now);
        poll();
    }
}

static void begin(uint8_t rules_size)
{
    if (!javino_board_init(&board, memory, sizeof memory, write_byte, NULL) ||
        (rules_size && !javino_rules_init(&board, rules_size, react, NULL)))
        stream_end();
    board.link.actions = actions;
    board.link.action_size = sizeof *actions;
    board.link.action_count = sizeof actions / sizeof *actions;
    later = 0;
    percepts_length = 0;
}

static void set_percepts(const uint8_t *bytes, uint16_t length)
{
    if (length > sizeof percepts)
        stream_end();
    memcpy(percepts, bytes, length);
    percepts_length = length;
}

/* ---- Parts of the core ---- */

static javino_decoder decoder;

static void find_frames(void)
{
    const uint8_t *frame;
    while ((frame = javino_decoder_next(&decoder, now))) {
        uint8_t length = (uint8_t)(decoder.taken - JAVINO_OVERHEAD);
        uint16_t i;
        if (*frame != JAVINO_START) {
            note_carried((const char *)frame + JAVINO_PAYLOAD_AT_1, length);
            continue;
        }
        for (i = JAVINO_LENGTH_AT; i < (uint16_t)(JAVINO_PAYLOAD_AT + length); i++)
            write_byte(NULL, frame[i]);
    }
}

static void decode(const uint8_t *bytes, uint16_t length)
{
    find_frames();
    while (length--) {
        if (!javino_decoder_ready(&decoder))
            stream_end();
        javino_decoder_put(&decoder, *bytes++, now);
        find_frames();
    }
}

static void begin_decoder(uint8_t nonce)
{
    if (!javino_decoder_init(&decoder, memory, JAVINO_WINDOW, 100))
        stream_end();
    if (nonce)
        javino_decoder_session(&decoder, nonce);
}

static void checksum(const uint8_t *bytes, uint16_t length)
{
    uint16_t crc = JAVINO_CRC_START(0);
    while (length--)
        crc = javino_crc16(crc, *bytes++);
    write_byte(NULL, (uint8_t)(crc >> 8));
    write_byte(NULL, (uint8_t)crc);
}

static void encode(uint8_t version, uint8_t nonce, const uint8_t *bytes, uint16_t length)
{
    javino_encoder encoder;
    memset(&encoder, 0, sizeof encoder);
    encoder.write = write_byte;
    if (version == 1) {
        javino_encoder_begin(&encoder, (uint8_t)length);
    } else {
        javino_encoder_begin2(&encoder, nonce, bytes[0], bytes[1], (uint8_t)(length - 2));
        bytes += 2;
        length -= 2;
    }
    javino_encoder_finish(&encoder, (const char *)bytes, (uint8_t)length);
}

/* ---- Records ---- */

static struct {
    char what;
    uint8_t flag;
    uint16_t now;
    uint16_t length;
} record;

static uint8_t bytes[8192];

static void take_record(void)
{
    now = record.now;
    switch (record.what) {
    case 'n': begin(record.flag); break;
    case 'b': receive(bytes, record.length); break;
    case 'p': set_percepts(bytes, record.length); break;
    case 'u': answer(); break;
    case 'l': javino_rules_look(&board, perceive, now); break;
    case 'd': javino_link_done(&board.link, later, record.flag); break;
    case 'c': checksum(bytes, record.length); break;
    case 'e': encode(1, 0, bytes, record.length); break;
    case 'E': encode(2, record.flag, bytes, record.length); break;
    case 's': begin_decoder(record.flag); break;
    case 'r': decode(bytes, record.length); break;
    default: stream_end();
    }
}

int main(void)
{
    while (stream_read(&record, sizeof record) && record.length <= sizeof bytes && stream_read(bytes, record.length)) {
        take_record();
        reply();
    }
    stream_end();
    return 0;
}
